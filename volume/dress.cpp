#include <isocast/math/vec.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/dress.h>
#include <isocast/volume/sample.h>

#include <algorithm>

namespace isocast {
namespace {

// A hit in grid space: its cell and its place in it.
struct CellPoint {
  std::int64_t cell[3];
  Vec3<double> p;
};

CellPoint locate(const VolumeDressing& dressing, const Double3& world, std::int64_t index) {
  const auto& dims = dressing.volume.dims;
  const Double3 grid = dressing.grid_from_world.point(world);
  CellPoint c{{index % dims[0], index / dims[0] % dims[1], index / (dims[0] * dims[1])}, {}};
  c.p = {clamp01(grid[0] - double(c.cell[0])), clamp01(grid[1] - double(c.cell[1])),
         clamp01(grid[2] - double(c.cell[2]))};
  return c;
}

template <class S> struct Samples {
  const Volume& volume;
  double at(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return double(
        number(reinterpret_cast<const S*>(volume.samples)[(z * volume.dims[1] + y) * volume.dims[0] + x]));
  }
  void corners(const std::int64_t (&c)[3], double (&f)[8]) const {
    for (int i = 0; i < 8; ++i) f[i] = at(c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2));
  }
  // Central difference along an axis, one-sided at the border.
  double difference(std::array<std::int64_t, 3> c, int axis) const {
    auto lo = c, hi = c;
    lo[axis] = std::max<std::int64_t>(c[axis] - 1, 0);
    hi[axis] = std::min(c[axis] + 1, volume.dims[axis] - 1);
    return (at(hi[0], hi[1], hi[2]) - at(lo[0], lo[1], lo[2])) / double(hi[axis] - lo[axis]);
  }
};

// Gradient of the trilinear interpolant in cell space.
Double3 cell_gradient(const double (&f)[8], const Vec3<double>& p) {
  const auto plane = [](double a, double b, double c, double d, double u, double v) {
    return lerp(lerp(a, b, u), lerp(c, d, u), v);
  };
  return {plane(f[1] - f[0], f[3] - f[2], f[5] - f[4], f[7] - f[6], p.y, p.z),
          plane(f[2] - f[0], f[3] - f[1], f[6] - f[4], f[7] - f[5], p.x, p.z),
          plane(f[4] - f[0], f[5] - f[1], f[6] - f[2], f[7] - f[3], p.x, p.y)};
}

template <class S> Double3 difference_gradient(const Samples<S>& samples, const CellPoint& c) {
  Double3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    double g[8];
    for (int i = 0; i < 8; ++i)
      g[i] = samples.difference({c.cell[0] + (i & 1), c.cell[1] + (i >> 1 & 1), c.cell[2] + (i >> 2)}, axis);
    gradient[axis] = trilinear(g, c.p);
  }
  return gradient;
}

template <class S>
void dress(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
           const DressWishes& wishes, DressedHits& dressed) {
  const Samples<S> samples{dressing.volume};
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != dressing.object || !(hits.t[i] < __builtin_inf())) continue;
    const Double3 d = {rays.dx[i], rays.dy[i], rays.dz[i]};
    const Double3 world = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + hits.t[i] * d;
    if (wishes.position)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = world[a];
    if (!wishes.normal && !wishes.value) continue;
    const CellPoint c = locate(dressing, world, hits.cell[i]);
    double f[8];
    samples.corners(c.cell, f);
    if (wishes.value)
      dressed.value[i] = dressing.volume.slope * trilinear(f, c.p) + dressing.volume.intercept;
    if (!wishes.normal) continue;
    const Double3 gradient =
        dressing.normals == NormalKind::gradient ? cell_gradient(f, c.p) : difference_gradient(samples, c);
    const Double3 normal = normalized(dressing.grid_from_world.transposed_vector(gradient));
    const double turn = dot(normal, d) > 0 ? -1 : 1;
    for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
  }
}

}  // namespace

void dress_volume_hits(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
                       const DressWishes& wishes, DressedHits& dressed) {
  visit_sample_type(dressing.volume.type, [&](auto tag) {
    dress<typename decltype(tag)::Type>(dressing, rays, hits, wishes, dressed);
  });
}

}  // namespace isocast
