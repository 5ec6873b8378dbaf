#include <isocast/math/vec.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/dense_grid.h>
#include <isocast/volume/dress.h>
#include <isocast/volume/sparse_grid.h>

#include <algorithm>

namespace isocast {
namespace {

// A hit in grid space: its cell and its place in it.
struct CellPoint {
  std::int32_t cell[3];
  Vec3<double> p;
};

CellPoint locate(const VolumeDressing& dressing, const Double3& world, const HitStream& hits, int i) {
  const Double3 grid = dressing.grid_from_world.point(world);
  CellPoint c{{hits.cell[0][i], hits.cell[1][i], hits.cell[2][i]}, {}};
  c.p = {clamp01(grid[0] - double(c.cell[0])), clamp01(grid[1] - double(c.cell[1])),
         clamp01(grid[2] - double(c.cell[2]))};
  return c;
}

// Grid: DenseGrid or SparseGrid.
template <class Grid> struct Samples {
  const Grid& grid;
  const SampleBox& box;
  double at(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return double(number(grid.at({x, y, z})));
  }
  void corners(const std::int32_t (&c)[3], double (&f)[8]) const {
    for (int i = 0; i < 8; ++i) f[i] = at(c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2));
  }
  // Central difference along an axis, one-sided at the border.
  double difference(std::array<std::int32_t, 3> c, int axis) const {
    auto lo = c, hi = c;
    lo[axis] = std::max(c[axis] - 1, box.first[axis]);
    hi[axis] = std::min(c[axis] + 1, box.last[axis]);
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

template <class Grid> Double3 difference_gradient(const Samples<Grid>& samples, const CellPoint& c) {
  Double3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    double g[8];
    for (int i = 0; i < 8; ++i)
      g[i] = samples.difference({c.cell[0] + (i & 1), c.cell[1] + (i >> 1 & 1), c.cell[2] + (i >> 2)}, axis);
    gradient[axis] = trilinear(g, c.p);
  }
  return gradient;
}

template <class Grid>
void dress(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
           const DressWishes& wishes, DressedHits& dressed) {
  const Grid grid(dressing.query);
  const Samples<Grid> samples{grid, dressing.query.samples};
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != dressing.query.object || !(hits.t[i] < __builtin_inf())) continue;
    const Double3 d = {rays.dx[i], rays.dy[i], rays.dz[i]};
    const Double3 world = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + hits.t[i] * d;
    if (wishes.position)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = world[a];
    if (!wishes.normal && !wishes.value) continue;
    const CellPoint c = locate(dressing, world, hits, i);
    double f[8];
    samples.corners(c.cell, f);
    if (wishes.value) dressed.value[i] = dressing.slope * trilinear(f, c.p) + dressing.intercept;
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
  if (dressing.query.sparse)
    visit_sparse_type(dressing.query.tree.type, [&]<class S>(SparseTag<S>) {
      dress<SparseGrid<S>>(dressing, rays, hits, wishes, dressed);
    });
  else
    visit_sample_type(dressing.query.grid.type, [&]<class S>(SampleTag<S>) {
      dress<DenseGrid<S>>(dressing, rays, hits, wishes, dressed);
    });
}

}  // namespace isocast
