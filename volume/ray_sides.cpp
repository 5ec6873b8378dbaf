// On which side of its iso-values a ray runs that crosses none.
#include <isocast/isa/cpu.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/visit_grid.h>
#include <isocast/volume/volume_surface.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// Where on its way through the grid a ray is looked at, as shares, until that tells.
constexpr double kShares[] = {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875};

// The way of a ray through the grid, in grid space; false where it misses.
struct GridWay {
  double o[3], d[3], near, far;
};
bool find_way(const VolumeQuery& query, const RayStream& rays, int i, GridWay& way) {
  way.near = rays.t_min[i], way.far = rays.t_max[i];
  for (int a = 0; a < 3; ++a) {
    const double(&m)[4] = query.grid_from_world[a];
    way.o[a] = m[0] * rays.ox[i] + m[1] * rays.oy[i] + m[2] * rays.oz[i] + m[3];
    way.d[a] = m[0] * rays.dx[i] + m[1] * rays.dy[i] + m[2] * rays.dz[i];
    const double lo = query.samples.first[a], hi = query.samples.last[a];
    if (way.d[a] == 0 && (way.o[a] < lo || way.o[a] > hi)) return false;
    if (way.d[a] == 0) continue;
    const double t0 = (lo - way.o[a]) / way.d[a], t1 = (hi - way.o[a]) / way.d[a];
    way.near = std::max(way.near, std::min(t0, t1));
    way.far = std::min(way.far, std::max(t0, t1));
  }
  return way.near < way.far;
}

// The sides at one point; false where a corner of its cell is not finite. sure: no corner differs.
template <class Grid>
bool look(const VolumeQuery& query, const Grid& grid, const GridWay& way, double share, RaySides& sides) {
  const double t = way.near + share * (way.far - way.near);
  std::int32_t cell[3];
  Vec3<double> place;
  double* const in_cell[3] = {&place.x, &place.y, &place.z};
  for (int a = 0; a < 3; ++a) {
    const double p = way.o[a] + t * way.d[a];
    cell[a] = static_cast<std::int32_t>(
        std::clamp(std::floor(p), double(query.samples.first[a]), double(query.samples.last[a] - 1)));
    *in_cell[a] = std::clamp(p - cell[a], 0.0, 1.0);
  }
  sides = {0, true};
  for (int iso = 0; iso < query.iso_count; ++iso) {
    double f[8], finite = 0;
    int below = 0;
    for (int k = 0; k < 8; ++k) {
      const auto sample = grid.at({cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)});
      f[k] = corner_value<double>(sample, query.iso[iso]);
      finite += f[k] * 0;
      below += f[k] < 0;
    }
    if (finite != 0) return false;
    sides.below |= std::uint32_t(trilinear(f, place) < 0) << iso;
    sides.sure = sides.sure && (below == 0 || below == 8);
  }
  return true;
}

}  // namespace

void VolumeSurface::find_sides(const RayStream& rays, const HitStream& hits,
                               RaySides (&sides)[kStreamSize]) const {
  const DefaultFloatEnvironment environment;
  visit_grid(query_, [&]<class Grid>(GridTag<Grid>) {
    const Grid grid(query_);
    for (int i = 0; i < rays.size; ++i) {
      if (is_hit(hits, i)) continue;
      sides[i] = {0, true};
      GridWay way = {};
      if (bounds_.empty() || !find_way(query_, rays, i, way)) continue;
      sides[i].sure = false;
      for (const double share : kShares) {
        RaySides one;
        if (!look(query_, grid, way, share, one)) continue;
        sides[i] = one;
        if (one.sure) break;
      }
    }
  });
}

}  // namespace isocast
