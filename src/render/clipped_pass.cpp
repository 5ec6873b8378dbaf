#include <isocast/render/clipped_pass.h>

namespace isocast {

std::unique_ptr<PrimaryPass> ClippedSurface::primary(const View& view) const {
  std::unique_ptr<PrimaryPass> pass = surface_->primary(view);
  if (!pass) return nullptr;
  return std::make_unique<ClippedPass>(*this, view, std::move(pass));
}

void ClippedPass::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                             TraceCounts& counts) const {
  // the thread's own, but for a surface that is cut twice
  thread_local std::unique_ptr<BlockHits> spare;
  std::unique_ptr<BlockHits> whole = spare ? std::move(spare) : std::make_unique_for_overwrite<BlockHits>();
  whole->reset(surface_.proves(), hits.stop());
  pass_->first_hits(bx, by, offset_u, offset_v, *whole, counts);
  const auto rays = std::make_unique_for_overwrite<RayStream>();
  for (int y = 0; y < kBlockTiles; ++y)
    for (int x = 0; x < kBlockTiles; ++x) {
      if (!whole->is_open(x, y) || hits.unwanted()) continue;
      view_.fill(bx * kBlockTiles + x, by * kBlockTiles + y, offset_u, offset_v, *rays);
      surface_.first_hit_inside(*rays, whole->tile(x, y), hits.tile(x, y), counts);
    }
  spare = std::move(whole);
}

}  // namespace isocast
