// Where rays of a patch meet the planes of cells, with the bits that the walk has.
#pragma once

#include <isocast/volume/cell_planes.h>
#include <isocast/volume/int_lanes.h>
#include <isocast/volume/primary/ray_rows.h>

namespace isocast::inline ISO_ISA {

/// The same expression as in traverse.h: planes are met at (k - o) * inverse. cell: the first corners.
template <Real R, bool kOrthographic>
inline CellPlanes<R> meet_planes(const PatchLook& look, const RayColumns<R>& rays, const R (&cell)[3]) {
  CellPlanes<R> p;
  for (int a = 0; a < 3; ++a) {
    if (kOrthographic && look.parallel[a]) {
      p.near[a] = select(rays.other[a] == cell[a], R(-__builtin_inf()), R(__builtin_inf()));
      p.far[a] = R(__builtin_inf());
      continue;
    }
    const R o = kOrthographic ? rays.own[a] : R(look.shared[a]),
            inverse = kOrthographic ? R(look.shared_inverse[a]) : rays.other[a];
    const R low = (cell[a] - o) * inverse, high = (cell[a] + R(1) - o) * inverse;
    p.near[a] = min(low, high);
    p.far[a] = max(low, high);
  }
  order_planes(R(0), p);
  return p;
}

/// Entry and exit of the cell along one axis in its own coordinates (point_in_cell).
template <Real R> struct ChordEnds { R entry, exit; };
template <Real R, bool kOrthographic>
inline ChordEnds<R> chord_ends(const PatchLook& look, const RayColumns<R>& rays, const R (&cell)[3], int a,
                               const CellPlanes<R>& p, const CrossingAxes<R>& axis) {
  const R own = rays.own[a], shared = R(look.shared[a]), base = (kOrthographic ? own : shared) - cell[a],
          d = kOrthographic ? shared : own;
  const R entry = clamp01(base + p.t_in * d), exit = clamp01(base + p.t_out * d);
  const R upper = select(d < R(0), R(1), R(0));  // the face it enters through, if it is one of this axis
  return {select(axis.in == R(a), upper, entry), select(axis.out == R(a), R(1) - upper, exit)};
}

}  // namespace isocast::inline ISO_ISA
