#include <isocast/apps/bench/picture_case.h>
#include <isocast/render/camera.h>

namespace isocast::bench {

View view_of(const PictureCase& picture, const Box& bounds) {
  return View(frame(bounds, picture.scene.camera, double(picture.width) / picture.height), picture.width,
              picture.height);
}

std::vector<RayStream> primary_rays(const PictureCase& picture, const Box& bounds) {
  const View view = view_of(picture, bounds);
  std::vector<RayStream> streams;
  for (int ty = 0; ty * kTileSize < picture.height; ++ty)
    for (int tx = 0; tx * kTileSize < picture.width; ++tx)
      view.fill(tx, ty, 0.5, 0.5, streams.emplace_back());
  return streams;
}

void clear(std::vector<HitStream>& hits) {
  for (HitStream& stream : hits) isocast::clear(stream);
}

void trace(const Surface& surface, const std::vector<RayStream>& rays, std::vector<HitStream>& hits) {
  TraceCounts counts;
  for (std::size_t s = 0; s < rays.size(); ++s) surface.first_hit(rays[s], hits[s], counts);
}

void trace_picture(const Surface& surface, const View& view, const std::vector<RayStream>& rays,
                   std::vector<HitStream>& hits) {
  const std::unique_ptr<PrimaryPass> pass = surface.primary(view);
  if (!pass) {
    trace(surface, rays, hits);
    return;
  }
  const auto along = [](int pixels) { return (pixels + kTileSize - 1) / kTileSize; };
  const int columns = along(view.width()), rows = along(view.height());
  const auto block = std::make_unique_for_overwrite<BlockHits>();
  TraceCounts counts;
  for (int by = 0; by * kBlockTiles < rows; ++by)
    for (int bx = 0; bx * kBlockTiles < columns; ++bx) {
      block->reset(surface.proves());
      pass->first_hits(bx, by, 0.5, 0.5, *block, counts);
      for (int y = by * kBlockTiles; y < std::min((by + 1) * kBlockTiles, rows); ++y)
        for (int x = bx * kBlockTiles; x < std::min((bx + 1) * kBlockTiles, columns); ++x)
          if (block->is_open(x % kBlockTiles, y % kBlockTiles))
            hits[static_cast<std::size_t>(y * columns + x)] = block->tile(x % kBlockTiles, y % kBlockTiles);
    }
}

}  // namespace isocast::bench
