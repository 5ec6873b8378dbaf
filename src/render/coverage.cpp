#include <isocast/render/coverage.h>

namespace isocast {

bool take_spares(const TileCover& cover, Wave& wave) {
  bool any = false;
  for (int i = 0; i < wave.rays.size; ++i) {
    if (!is_ray(wave.rays, i) || cover.share[i] == 0 || is_hit(*wave.hits, i) || !is_hit(*cover.spare, i))
      continue;
    copy_slot(*cover.spare, *wave.hits, i);
    any = true;
  }
  return any;
}

void blend_cover(const Frame& frame, const TileCover& cover, const RayStream& rays, Film& film,
                 RenderCounts& counts) {
  for (int i = 0; i < rays.size; ++i) {
    const float share = cover.share[i];
    if (!is_ray(rays, i) || share == 1) continue;
    const Color behind = frame.scene.color_towards(direction_of(rays, i));
    float* pixel = film.color(rays.id[i]);
    for (int c = 0; c < 3; ++c) pixel[c] = share * pixel[c] + (1 - share) * behind[c];
    pixel[3] *= share;
    counts.blended += share > 0;
    counts.blended_open += cover.open[i] > 0;
  }
}

}  // namespace isocast
