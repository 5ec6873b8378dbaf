// In which order rays meet the planes of cells.
#pragma once

#include <isocast/math/pack.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

/// Where rays meet the planes of a cell each. They cross it if they meet all near ones before all far ones:
/// those that do surely do not have t_out < t_in.
template <Real R> struct CellPlanes {
  R near[3], far[3];
  Mask<R> start;  // the ray starts in the cell, or behind it
  R t_in, t_out;
};

/// All that follows from the planes' near and far ones. begin: where the rays start.
template <Real R> inline void order_planes(R begin, CellPlanes<R>& p) {
  const R entered = max(max(p.near[0], p.near[1]), p.near[2]);
  p.start = entered <= begin;
  p.t_in = max(entered, begin);
  p.t_out = min(min(p.far[0], p.far[1]), p.far[2]);
}

/// The axes of the last near and the first far plane by (t, axis), or kStart.
template <Real R> struct CrossingAxes { R in, out; };
template <Real R> inline CrossingAxes<R> crossing_axes(const CellPlanes<R>& p) {
  const R in = select(p.near[2] >= max(p.near[0], p.near[1]), R(2),
                      select(p.near[1] >= p.near[0], R(1), R(0))),
          out = select(p.far[2] < min(p.far[0], p.far[1]), R(2), select(p.far[1] < p.far[0], R(1), R(0)));
  return {select(p.start, R(kStart), in), out};
}

}  // namespace isocast::inline ISO_ISA
