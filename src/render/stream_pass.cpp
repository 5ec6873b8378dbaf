#include <isocast/render/stream_pass.h>

#include <algorithm>
#include <vector>

namespace isocast {

void StreamPass::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                            TraceCounts& counts) const {
  std::vector<RayStream> rays;
  std::vector<HitStream*> found;
  const int columns = (view_.width() + kTileSize - 1) / kTileSize,
            rows = (view_.height() + kTileSize - 1) / kTileSize;
  for (int ty = by * kBlockTiles; ty < std::min((by + 1) * kBlockTiles, rows); ++ty)
    for (int tx = bx * kBlockTiles; tx < std::min((bx + 1) * kBlockTiles, columns); ++tx) {
      if (!surface_.narrow(view_.frustum(tx, ty))) continue;
      view_.fill(tx, ty, offset_u, offset_v, rays.emplace_back());
      found.push_back(&hits.tile(tx % kBlockTiles, ty % kBlockTiles));
    }
  if (!rays.empty() && !hits.unwanted()) trace_(rays, found, counts);
}

}  // namespace isocast
