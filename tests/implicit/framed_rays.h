// The primary rays of the camera that frames a domain, and where the reference meets them.
#pragma once

#include <isocast/apps/reference/formula_reference.h>
#include <isocast/render/frame.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace isocast::test {

inline Double3 origin_of(const RayStream& rays, int i) { return {rays.ox[i], rays.oy[i], rays.oz[i]}; }

/// The part [lo, hi] of a ray from t = 0 that lies inside a box, less a few ulp at both ends: what different
/// roundings of them can make. Empty where lo >= hi.
struct Reach {
  double lo, hi;
  [[nodiscard]] bool empty() const { return !(lo < hi); }
  [[nodiscard]] bool holds(double begin, double end) const { return begin > lo && end < hi; }
};
inline Reach range_inside(const Box& box, const Double3& o, const Double3& d) {
  double lo = 0, hi = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a) {
    const double t0 = (box.lo[a] - o[a]) / d[a], t1 = (box.hi[a] - o[a]) / d[a];
    if (d[a] == 0 && (o[a] < box.lo[a] || o[a] > box.hi[a])) return {1, 0};
    if (d[a] == 0) continue;
    lo = std::max(lo, std::min(t0, t1));
    hi = std::min(hi, std::max(t0, t1));
  }
  const double few_ulp = 0x1p-49 * std::max(std::abs(lo), std::abs(hi));
  return {lo + few_ulp, hi - few_ulp};
}

/// Calls look(rays) for each tile of a picture of size x size pixels.
template <class Look> void each_tile(const Box& box, int size, Look look) {
  const View view(frame(box, {}, 1), size, size);
  const int tiles = (size + kTileSize - 1) / kTileSize;
  auto rays = std::make_unique<RayStream>();
  for (int tile = 0; tile < tiles * tiles; ++tile) {
    view.fill(tile % tiles, tile / tiles, 0.5, 0.5, *rays);
    look(*rays);
  }
}

/// The first hits of one surface; of a proving method every certificate tells.
inline HitStream first_hits(const Surface& surface, const RayStream& rays) {
  HitStream hits;
  clear(hits);
  std::ranges::fill(hits.certificate, Certificate::proved_miss);
  TraceCounts counts;
  surface.first_hit(rays, hits, counts);
  return hits;
}

/// First hits of a whole picture by the surface's pass, tile by tile: call(rays, hits), with a certificate
/// that tells in every slot.
template <class Call> void each_tile_of_pass(const Surface& surface, const View& view, Call call) {
  const std::unique_ptr<PrimaryPass> pass = surface.primary(view);
  const auto block = std::make_unique<BlockHits>();
  const auto rays = std::make_unique<RayStream>();
  constexpr int kSide = kBlockTiles * kTileSize;
  TraceCounts counts;
  for (int by = 0; by * kSide < view.height(); ++by)
    for (int bx = 0; bx * kSide < view.width(); ++bx) {
      block->reset(true);
      pass->first_hits(bx, by, 0.5, 0.5, *block, counts);
      for (int tile = 0; tile < kBlockStreams; ++tile) {
        const int x = tile % kBlockTiles, y = tile / kBlockTiles, tx = bx * kBlockTiles + x,
                  ty = by * kBlockTiles + y;
        if (tx * kTileSize >= view.width() || ty * kTileSize >= view.height()) continue;
        view.fill(tx, ty, 0.5, 0.5, *rays);
        call(*rays, block->tile(x, y));
      }
    }
}

}  // namespace isocast::test
