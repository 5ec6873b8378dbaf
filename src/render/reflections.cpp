#include <isocast/render/reflections.h>
#include <isocast/render/scene_rays.h>

namespace isocast {
namespace {

void add(Color& color, float weight, const Color& more) {
  for (int c = 0; c < 3; ++c) color[c] += weight * more[c];
}

// The share that hit i mirrors; none where its normal is zero or NaN.
float mirrored_share(const Frame& frame, const Wave& wave, int i) {
  const Double3 normal = normal_of(wave.dressed, i);
  return dot(normal, normal) > 0.5 ? material_of(frame.scene, *wave.hits, i).reflectivity : 0;
}

Double3 mirrored(const Double3& d, const Double3& normal) { return d - 2 * dot(d, normal) * normal; }

}  // namespace

void Reflections::color(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
                        RenderCounts& counts) {
  Color shaded[kStreamSize];
  const Wave* from = &wave;
  for (int bounce = 0;; ++bounce) {
    Wave& to = waves_[bounce % 2];
    to.hits = &hits_[bounce % 2];
    to.rays.size = 0;
    to.sample = wave.sample;
    shade(frame, *from, shadows, shaded, counts);
    for (int i = 0; i < from->rays.size; ++i) {
      if (!is_hit(*from->hits, i)) continue;
      const float share = bounce < frame.features.reflections ? mirrored_share(frame, *from, i) : 0;
      add(colors[from->slot[i]], from->weight[i] * (1 - share), shaded[i]);
      if (!(share > 0)) continue;
      to.slot[to.rays.size] = from->slot[i];
      to.weight[to.rays.size] = from->weight[i] * share;
      spawn(from->rays, *from->hits, i, mirrored(direction_of(from->rays, i), normal_of(from->dressed, i)),
            to.rays);
    }
    if (to.rays.size == 0) return;
    trace(frame, to, counts);
    for (int i = 0; i < to.rays.size; ++i)
      if (!is_hit(*to.hits, i))
        add(colors[to.slot[i]], to.weight[i], frame.scene.color_towards(direction_of(to.rays, i)));
    from = &to;
  }
}

void Reflections::trace(const Frame& frame, Wave& wave, RenderCounts& counts) {
  wave.rays.kind = RayKind::reflection;
  counts.reflection += wave.rays.size;
  clear(*wave.hits);
  find_first_hits(frame, wave.rays, *wave.hits, counts.trace);
  dress_all(frame, {.normal = true}, wave.rays, *wave.hits, wave.dressed);
}

}  // namespace isocast
