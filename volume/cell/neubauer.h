// Neubauer: repeated linear interpolation between entry and exit.
#pragma once

#include <isocast/volume/cell/linear.h>

namespace isocast::inline ISO_ISA {

/// Regula falsi on f, evaluated in the cell at every step: `iterations` steps, or until a step is below
/// kTolerance with `adaptive`. Misses two roots in a cell; of three it may return the last. source  Neubauer,
/// Mroz, Hauser, Wegenkittl: Cell-based first-hit ray casting, VisSym 2002; Marmitt et al., VMV 2004
template <Real R> ISO_HD inline Root<R> neubauer(const Cell<R>& cell, const CellOptions& options) {
  EndValues<R> ends = end_values(cell, options);
  Bracket<R>& b = ends.bracket;
  const R f_exit = b.fhi;
  R s = b.lo;
  if (any(ends.hit)) {
    const auto f = [&](R t) { return trilinear(cell.f, point_at(cell, t)); };
    s = options.adaptive ? regula_falsi_adaptive(f, b, R(kTolerance<Scalar<R>>), ends.hit)
                         : regula_falsi(f, b, options.iterations);
  }
  return {s, b.lo, b.hi, ends.hit, Mask<R>(false), negative(f_exit)};
}

}  // namespace isocast::inline ISO_ISA
