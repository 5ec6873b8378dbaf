// A case of the bench that is a picture: all primary rays of a scene of one object.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/ray/stream.h>
#include <isocast/ray/surface.h>
#include <isocast/render/camera.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// The scene's own method is not used.
struct PictureCase {
  std::string suite, name;
  SceneDescription scene;
  int width = 128, height = 128;
  [[nodiscard]] std::int64_t rays() const { return std::int64_t{width} * height; }
};

/// The camera, where the picture's scene leaves it open with these bounds in sight.
[[nodiscard]] View view_of(const PictureCase& picture, const Box& bounds);
/// The rays through the pixels' centres, a stream a tile.
[[nodiscard]] std::vector<RayStream> primary_rays(const PictureCase& picture, const Box& bounds);

/// No hit in any stream.
void clear(std::vector<HitStream>& hits);
/// First hits of every stream, each for itself; hits are cleared before.
void trace(const Surface& surface, const std::vector<RayStream>& rays, std::vector<HitStream>& hits);
/// The same of the view that primary_rays fills, by the surface's own order where it has one.
void trace_picture(const Surface& surface, const View& view, const std::vector<RayStream>& rays,
                   std::vector<HitStream>& hits);

/// Calls look(stream, slot) for every ray.
template <class Look> void each_ray(const std::vector<RayStream>& rays, Look look) {
  for (std::size_t s = 0; s < rays.size(); ++s)
    for (int i = 0; i < rays[s].size; ++i)
      if (rays[s].t_min[i] <= rays[s].t_max[i]) look(s, i);
}

}  // namespace isocast::bench
