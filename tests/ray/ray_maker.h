// Streams of random rays.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/ray/hit.h>

#include <limits>
#include <memory>
#include <random>

namespace isocast::test {

inline void set_ray(RayStream& rays, int i, const Double3& o, const Double3& d) {
  rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
  rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
  rays.t_min[i] = 0;
  rays.t_max[i] = std::numeric_limits<double>::infinity();
  rays.start_object[i] = kNoObject;
  rays.start_sides[i] = 0;
}

inline std::unique_ptr<RayStream> one_ray(const Double3& o, const Double3& d) {
  auto rays = std::make_unique<RayStream>();
  rays->size = 1;
  rays->kind = RayKind::reflection;
  set_ray(*rays, 0, o, d);
  return rays;
}

/// 256 rays from points of a sphere of this radius around `center` (half of them from inside it) to points
/// near its middle.
inline std::unique_ptr<RayStream> random_rays(std::mt19937& random, const Double3& center, double radius) {
  auto rays = std::make_unique<RayStream>();
  rays->size = kStreamSize;
  rays->kind = RayKind::reflection;
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto anywhere = [&](double r) {
    return r * normalized(Double3{normal(random), normal(random), normal(random)});
  };
  for (int i = 0; i < rays->size; ++i) {
    const Double3 from = anywhere(i % 2 ? radius : radius * uniform(random)),
                  to = anywhere(0.6 * radius * uniform(random));
    set_ray(*rays, i, center + from, normalized(to - from));
  }
  return rays;
}

inline Double3 at(const RayStream& rays, int i, double t) {
  return {rays.ox[i] + t * rays.dx[i], rays.oy[i] + t * rays.dy[i], rays.oz[i] + t * rays.dz[i]};
}

}  // namespace isocast::test
