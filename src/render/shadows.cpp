#include <isocast/render/shadows.h>

#include <algorithm>

namespace isocast {

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
  if (rays_.size == 0) return;
  if (frame.features.transparency) {
    pass_layers(frame, counts);
    for (int n = 0; n < rays_.size; ++n) visible[hit_of_[n]] = passed_[n];
    return;
  }
  bool blocked[kStreamSize] = {};
  for (const SceneObject& object : frame.scene.objects) object.surface->any_hit(rays_, blocked, counts.trace);
  for (int n = 0; n < rays_.size; ++n) visible[hit_of_[n]] = blocked[n] ? 0 : 1;
}

// As many layers as the eye sees through; what lies behind them is opaque.
void Shadows::pass_layers(const Frame& frame, RenderCounts& counts) {
  std::fill_n(passed_, rays_.size, 1.0f);
  clear(hits_);
  crossings_.first(frame.scene, frame.objects, rays_, hits_, counts.trace);
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
    crossings_.next(frame.scene, frame.objects, rays_, hits_, counts);
  }
}

}  // namespace isocast
