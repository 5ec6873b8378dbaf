#include <isocast/math/elementary.h>
#include <isocast/render/scene_rays.h>
#include <isocast/render/shadows.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

// A unit vector on the normal's side, its density the cosine of their angle. The two that complete the
// normal: Duff et al.: Building an orthonormal basis, revisited, JCGT 6(1), 2017.
Double3 cosine_direction(const Double3& n, const UnitPoint& point) {
  const double sign = std::copysign(1.0, n[2]), a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
  const Double3 x = {1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
                y = {b, sign + n[1] * n[1] * a, -n[1]};
  const double r = std::sqrt(point.u), angle = 2 * std::numbers::pi * point.v;
  return (r * cos(angle)) * x + (r * sin(angle)) * y + std::sqrt(1 - point.u) * n;
}

}  // namespace

void Shadows::trace(const Frame& frame, const Wave& wave, const Double3& to_light,
                    float (&visible)[kStreamSize], RenderCounts& counts) {
  std::ranges::fill(visible, 1.0f);
  rays_.size = 0;
  rays_.kind = RayKind::shadow;
  for (int i = 0; i < wave.rays.size; ++i) {
    if (!is_hit(*wave.hits, i) || dot(normal_of(wave.dressed, i), to_light) <= 0) continue;
    hit_of_[rays_.size] = i;
    spawn(wave.rays, *wave.hits, i, to_light, rays_);
  }
  counts.shadow += rays_.size;
  pass(frame, counts);
  for (int n = 0; n < rays_.size; ++n) visible[hit_of_[n]] = passed_[n];
}

void Shadows::look_around(const Frame& frame, const Wave& wave, float (&open)[kStreamSize],
                          RenderCounts& counts) {
  const AmbientOcclusion& light = frame.scene.ambient_occlusion;
  std::ranges::fill(open, 1.0f);
  rays_.kind = RayKind::shadow;
  for (int k = 0; k < light.samples; ++k) {
    const auto index = static_cast<std::uint32_t>(wave.sample * light.samples + k);
    rays_.size = 0;
    for (int i = 0; i < wave.rays.size; ++i) {
      const Double3 normal = normal_of(wave.dressed, i);
      if (!is_hit(*wave.hits, i) || !(dot(normal, normal) > 0.5)) continue;
      const std::uint32_t seed = seed_of(wave.rays.id[i]);
      hit_of_[rays_.size] = i;
      spawn(wave.rays, *wave.hits, i, cosine_direction(normal, scrambled_sobol(index, seed, seed_of(seed))),
            rays_);
      rays_.t_max[rays_.size - 1] = light.radius;
    }
    counts.occlusion += rays_.size;
    pass(frame, counts);
    for (int n = 0; n < rays_.size; ++n)
      open[hit_of_[n]] -= (1 - passed_[n]) / static_cast<float>(light.samples);
  }
}

// The share of light that comes along each of the rays.
void Shadows::pass(const Frame& frame, RenderCounts& counts) {
  if (rays_.size == 0) return;
  if (frame.features.transparency) return pass_layers(frame, counts);
  bool blocked[kStreamSize] = {};
  find_any_hits(frame, rays_, blocked, counts.trace);
  for (int n = 0; n < rays_.size; ++n) passed_[n] = blocked[n] ? 0 : 1;
}

// As many layers as the eye sees through; what lies behind them is opaque.
void Shadows::pass_layers(const Frame& frame, RenderCounts& counts) {
  std::fill_n(passed_, rays_.size, 1.0f);
  clear(hits_);
  const std::span<const std::uint16_t> objects = objects_for(frame, rays_, candidates_);
  crossings_.first(frame.scene, objects, rays_, hits_, counts.trace);
  for (int layer = 1;; ++layer) {
    const bool behind = layer > frame.settings.transparency_depth;
    bool any = false;
    for (int n = 0; n < rays_.size; ++n) {
      if (!is_hit(hits_, n)) continue;
      const float opacity = material_of(frame.scene, hits_, n).opacity;
      passed_[n] *= behind && opacity > 0 ? 0 : 1 - opacity;
      if (passed_[n] > 0) any = true;
      else forget(hits_, n);
    }
    if (behind || !any) return;
    crossings_.next(frame.scene, objects, rays_, hits_, counts);
  }
}

}  // namespace isocast
