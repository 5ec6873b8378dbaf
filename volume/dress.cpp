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

// Those of cells, packet by packet of a stream.
template <class Grid> class Dresser {
 public:
  Dresser(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits)
      : dressing_(dressing), rays_(rays), hits_(hits), grid_(dressing.query) {}

  void dress(int first, const DressWishes& wishes, DressedHits& dressed) {
    const DressKernels& kernels = dressing_.kernels;
    const double(&grid_from_world)[3][4] = dressing_.query.grid_from_world;
    prefetch(first + kPacketSize);
    if (!find_mine(first)) return;
    kernels.locate(grid_from_world, rays_, hits_, first, work_);
    for (int l = 0; l < kPacketSize; ++l)
      if (wishes.position && work_.mine[l] > 0)
        for (int a = 0; a < 3; ++a) dressed.position[a][first + l] = work_.world[a][l];
    const bool smooth = dressing_.normals == NormalKind::difference;
    if (wishes.value || (wishes.normal && !smooth)) load_corners(first);
    if (wishes.value) kernels.interpolate(dressing_.slope, dressing_.intercept, first, work_, dressed.value);
    if (!wishes.normal) return;
    if (smooth) difference(first);
    else kernels.differentiate(work_);
    kernels.turn(grid_from_world, rays_, first, work_, dressed.normal);
  }

 private:
  bool is_mine(int i) const { return hits_.object[i] == dressing_.query.object && is_hit(hits_, i); }

  void prefetch(int first) const {
    for (int i = first; i < std::min(first + kPacketSize, rays_.size); ++i)
      if (is_mine(i)) grid_.prefetch({hits_.cell[0][i], hits_.cell[1][i], hits_.cell[2][i]});
  }

  bool find_mine(int first) {
    bool any = false;
    for (int l = 0; l < kPacketSize; ++l) {
      const bool mine = first + l < rays_.size && is_mine(first + l);
      work_.mine[l] = mine;
      any = any || mine;
    }
    return any;
  }

  void load_corners(int first) {
    for (int l = 0; l < kPacketSize; ++l) {
      if (!(work_.mine[l] > 0)) continue;
      const std::int32_t cell[3] = {hits_.cell[0][first + l], hits_.cell[1][first + l],
                                    hits_.cell[2][first + l]};
      typename Grid::Sample raw[8];
      grid_.enter(cell, place_);
      grid_.load_corners(cell, place_, raw);
      for (int k = 0; k < 8; ++k) work_.corners[k][l] = double(number(raw[k]));
    }
  }

  void difference(int first) {
    const Samples<Grid> samples{grid_, dressing_.query.samples};
    for (int l = 0; l < kPacketSize; ++l) {
      if (!(work_.mine[l] > 0)) continue;
      const int i = first + l;
      const Vec3<double> p = {work_.place[0][l], work_.place[1][l], work_.place[2][l]};
      for (int axis = 0; axis < 3; ++axis) {
        double g[8];
        for (int k = 0; k < 8; ++k)
          g[k] = samples.difference(
              {hits_.cell[0][i] + (k & 1), hits_.cell[1][i] + (k >> 1 & 1), hits_.cell[2][i] + (k >> 2)},
              axis);
        work_.gradient[axis][l] = trilinear(g, p);
      }
    }
  }

  const VolumeDressing& dressing_;
  const RayStream& rays_;
  const HitStream& hits_;
  const Grid grid_;
  typename Grid::Place place_;
  HitsToDress work_;
};

}  // namespace

void dress_volume_hits(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
                       const DressWishes& wishes, DressedHits& dressed) {
  visit_grid(dressing.query, [&]<class Grid>(GridTag<Grid>) {
    Dresser<Grid> dresser(dressing, rays, hits);
    for (int first = 0; first < rays.size; first += kPacketSize) dresser.dress(first, wishes, dressed);
  });
}

}  // namespace isocast
