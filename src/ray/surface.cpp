#include <isocast/ray/surface.h>

namespace isocast {

std::unique_ptr<PrimaryPass> Surface::primary(const View& /*view*/) const { return nullptr; }

void Surface::find_sides(const RayStream& rays, const HitStream& hits, RaySides (&sides)[kStreamSize]) const {
  for (int i = 0; i < rays.size; ++i)
    if (!is_hit(hits, i)) sides[i] = {0, true};
}

std::unique_ptr<CoveragePass> Surface::coverage(const View& /*view*/) const { return nullptr; }

void Surface::find_edges(const PixelLines& /*lines*/, std::span<const EdgeStep> /*steps*/,
                         std::span<float> /*shares*/) const {}

void Surface::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  HitStream hits;
  clear(hits);
  first_hit(rays, hits, counts);
  for (int i = 0; i < rays.size; ++i) hit[i] = hit[i] || hits.t[i] < __builtin_inf();
}

}  // namespace isocast
