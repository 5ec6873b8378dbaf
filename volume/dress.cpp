#include <isocast/math/vec.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/dress.h>
#include <isocast/volume/visit_grid.h>

#include <algorithm>

namespace isocast {
namespace {

// Grid: DenseGrid or SparseGrid.
template <class Grid> struct Samples {
  const Grid& grid;
  const SampleBox& box;
  double at(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return double(number(grid.at({x, y, z})));
  }
  // Central difference along an axis, one-sided at the border.
  double difference(std::array<std::int32_t, 3> c, int axis) const {
    auto lo = c, hi = c;
    lo[axis] = std::max(c[axis] - 1, box.first[axis]);
    hi[axis] = std::min(c[axis] + 1, box.last[axis]);
    return (at(hi[0], hi[1], hi[2]) - at(lo[0], lo[1], lo[2])) / double(hi[axis] - lo[axis]);
  }
};

template <class Grid>
void load_corners(const Samples<Grid>& samples, const HitStream& hits, int size, HitsToDress& dress) {
  for (int i = 0; i < size; ++i) {
    if (!(dress.mine[i] > 0)) continue;
    const std::int32_t x = hits.cell[0][i], y = hits.cell[1][i], z = hits.cell[2][i];
    for (int k = 0; k < 8; ++k) dress.corners[k][i] = samples.at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
  }
}

template <class Grid>
void difference(const Samples<Grid>& samples, const HitStream& hits, int size, HitsToDress& dress) {
  for (int i = 0; i < size; ++i) {
    if (!(dress.mine[i] > 0)) continue;
    const Vec3<double> p = {dress.place[0][i], dress.place[1][i], dress.place[2][i]};
    for (int axis = 0; axis < 3; ++axis) {
      double g[8];
      for (int k = 0; k < 8; ++k)
        g[k] = samples.difference(
            {hits.cell[0][i] + (k & 1), hits.cell[1][i] + (k >> 1 & 1), hits.cell[2][i] + (k >> 2)}, axis);
      dress.gradient[axis][i] = trilinear(g, p);
    }
  }
}

template <class Grid>
void dress(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
           const DressWishes& wishes, DressedHits& dressed) {
  const Grid grid(dressing.query);
  const Samples<Grid> samples{grid, dressing.query.samples};
  const DressKernels& kernels = dressing.kernels;
  const double(&grid_from_world)[3][4] = dressing.query.grid_from_world;
  HitsToDress work;
  bool any = false;
  for (int i = 0; i < rays.size; ++i) {
    const bool mine = hits.object[i] == dressing.query.object && is_hit(hits, i);
    work.mine[i] = mine;
    any = any || mine;
  }
  std::fill(work.mine + rays.size, std::end(work.mine), 0.0);
  if (!any) return;
  kernels.locate(grid_from_world, rays, hits, work);
  for (int i = 0; i < rays.size; ++i)
    if (wishes.position && work.mine[i] > 0)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = work.world[a][i];
  const bool smooth = dressing.normals == NormalKind::difference;
  if (wishes.value || (wishes.normal && !smooth)) load_corners(samples, hits, rays.size, work);
  if (wishes.value) kernels.interpolate(dressing.slope, dressing.intercept, rays.size, work, dressed.value);
  if (!wishes.normal) return;
  if (smooth) difference(samples, hits, rays.size, work);
  else kernels.differentiate(rays.size, work);
  kernels.turn(grid_from_world, rays, work, dressed.normal);
}

}  // namespace

void dress_volume_hits(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
                       const DressWishes& wishes, DressedHits& dressed) {
  visit_grid(dressing.query,
             [&]<class Grid>(GridTag<Grid>) { dress<Grid>(dressing, rays, hits, wishes, dressed); });
}

}  // namespace isocast
