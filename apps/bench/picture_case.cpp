#include <isocast/apps/bench/picture_case.h>
#include <isocast/render/camera.h>

namespace isocast::bench {

std::vector<RayStream> primary_rays(const PictureCase& picture, const Box& bounds) {
  const View view(frame(bounds, picture.scene.camera, double(picture.width) / picture.height), picture.width,
                  picture.height);
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

}  // namespace isocast::bench
