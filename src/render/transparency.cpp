#include <isocast/render/scene_rays.h>
#include <isocast/render/transparency.h>

#include <algorithm>

namespace isocast {

namespace {

// What a ray that nothing holds back ends in, and every hit in the colour of its own.
void add_opaque_colors(const Frame& frame, TileBuffers& b, Film& film, RenderCounts& counts) {
  const RayStream& rays = b.primary.rays;
  Color colors[kStreamSize];
  shade(frame, b.primary, b.shadows, colors, counts);
  const float share = 1.0f / static_cast<float>(frame.settings.spp);
  for (int i = 0; i < rays.size; ++i) {
    if (!is_ray(rays, i)) continue;
    const bool hit = is_hit(*b.primary.hits, i);
    const Color color = hit ? colors[i] : frame.scene.color_towards(direction_of(rays, i));
    float* pixel = film.color(rays.id[i]);
    for (int c = 0; c < 3; ++c) pixel[c] += share * color[c];
    if (hit) pixel[3] += share;
  }
}

}  // namespace

void trace_first_hits(const Frame& frame, HitStream* found, TileBuffers& b, TraceCounts& counts) {
  const RayStream& rays = b.primary.rays;
  b.primary.hits = found ? found : &b.hits;
  HitStream& hits = *b.primary.hits;
  if (!found) {
    clear(hits);
    if (frame.proves) std::ranges::fill(hits.certificate, Certificate::proved_miss);
  }
  if (frame.hierarchy) {
    if (!frame.features.transparency) return frame.hierarchy->first_hit(rays, frame.passed, hits, counts);
    frame.hierarchy->find_candidates(rays, b.candidates);
    return b.crossings.first(frame.scene, b.candidates, rays, hits, counts);
  }
  const auto has_pass = [&](std::uint16_t object) { return !frame.passes.empty() && frame.passes[object]; };
  if (frame.features.transparency && !std::ranges::any_of(b.candidates, has_pass)) {
    b.crossings.first(frame.scene, b.candidates, rays, hits, counts);
    return;
  }
  for (const std::uint16_t object : b.candidates)
    if (!has_pass(object)) frame.scene.objects[object].surface->first_hit(rays, hits, counts);
}

void dress_hits(const Frame& frame, const DressWishes& wishes, TileBuffers& b) {
  dress_all(frame, wishes, b.primary.rays, *b.primary.hits, b.primary.dressed);
}

void add_colors(const Frame& frame, TileBuffers& b, Film& film, RenderCounts& counts) {
  if (!frame.features.transparency && frame.features.reflections == 0)
    return add_opaque_colors(frame, b, film, counts);
  Wave& primary = b.primary;
  const RayStream& rays = primary.rays;
  HitStream& hits = *primary.hits;
  for (int i = 0; i < rays.size; ++i) {
    primary.slot[i] = i;
    primary.weight[i] = 1;
  }
  Color sum[kStreamSize] = {};
  float through[kStreamSize];
  std::ranges::fill(through, 1.0f);
  for (int layer = 1;; ++layer) {
    Color colors[kStreamSize] = {};
    b.reflections.color(frame, primary, b.shadows, colors, counts);
    float opacity[kStreamSize] = {};
    bool more = false;
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(hits, i)) continue;
      opacity[i] = material_of(frame.scene, hits, i).opacity;
      if (opacity[i] < 1) more = true;
      else forget(hits, i);
    }
    if (more) b.crossings.next(frame.scene, b.candidates, rays, hits, counts);
    const bool last = layer == frame.settings.transparency_depth;
    for (int i = 0; i < rays.size; ++i) {
      if (last && opacity[i] > 0 && is_hit(hits, i)) opacity[i] = 1;
      for (int c = 0; c < 3; ++c) sum[i][c] += through[i] * opacity[i] * colors[i][c];
      through[i] *= 1 - opacity[i];
    }
    if (!more || last) break;
    dress_hits(frame, {.normal = true}, b);
  }

  const float share = 1.0f / static_cast<float>(frame.settings.spp);
  for (int i = 0; i < rays.size; ++i) {
    if (!is_ray(rays, i)) continue;
    float* pixel = film.color(rays.id[i]);
    if (through[i] > 0) {
      const Color behind = frame.scene.color_towards(direction_of(rays, i));
      for (int c = 0; c < 3; ++c) sum[i][c] += through[i] * behind[c];
    }
    for (int c = 0; c < 3; ++c) pixel[c] += share * sum[i][c];
    pixel[3] += share * (1 - through[i]);
  }
}

}  // namespace isocast
