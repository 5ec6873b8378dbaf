// Streams of rays for tests of surfaces.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/ray/surface.h>

#include <memory>
#include <random>

namespace isocast::test {

struct Streams {
  RayStream rays;
  HitStream hits;
};
inline std::unique_ptr<Streams> make_streams() {
  auto s = std::make_unique<Streams>();
  s->rays.size = 0;
  s->rays.kind = RayKind::reflection;
  clear(s->hits);
  return s;
}

inline void add_ray(RayStream& rays, const Double3& o, const Double3& d, double t_max = __builtin_inf()) {
  const int i = rays.size++;
  rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
  rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
  rays.t_min[i] = 0;
  rays.t_max[i] = t_max;
  rays.id[i] = static_cast<std::uint32_t>(i);
  rays.start_object[i] = kNoObject;
  rays.start_sides[i] = 0;
}

/// A direction that is often parallel to an axis or a diagonal, or leads through a lattice point from o.
inline Double3 awkward_direction(std::mt19937_64& random, const Double3& o) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (;;) {
    Double3 d = {unit(random), unit(random), unit(random)};
    const int kind = pick(4);
    if (kind == 0) d = {double(pick(3) - 1), double(pick(3) - 1), double(pick(3) - 1)};
    if (kind == 1)
      d = Double3{std::floor(o[0]) + pick(9) - 4, std::floor(o[1]) + pick(9) - 4,
                  std::floor(o[2]) + pick(9) - 4} -
          o;
    if (kind == 2) d[pick(3)] *= 1e-7;
    if (length(d) > 0) return d;
  }
}

}  // namespace isocast::test
