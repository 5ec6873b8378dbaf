// Where the rays of a beam run through the domain.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/math/rounding.h>

namespace isocast::inline ISO_ISA {

/// Depths between which rays enter the domain, and leave it: every true one lies there.
template <Real R> struct BoxRange {
  R enters_from = R(-kInfinity<Scalar<R>>), enters_to = enters_from, leaves_from = -enters_from,
    leaves_to = leaves_from;
};

/// Of all rays within `half` pixels of (u, v). A ray that may run along a face is not known to enter or leave
/// there.
template <Real R> ISO_HD inline BoxRange<R> box_range(const BlockRays<Scalar<R>>& rays, R u, R v, R half) {
  using T = Scalar<R>;
  const R infinite = R(kInfinity<T>);
  BoxRange<R> range;
  range.enters_from = range.enters_to = R(-rays.before);
  for (int a = 0; a < 3; ++a) {
    const R su = R(rays.start_u[a]), sv = R(rays.start_v[a]), du = R(rays.span_u[a]), dv = R(rays.span_v[a]);
    const R o = R(rays.start[a]) + u * su + v * sv, d = R(rays.span[a]) + u * du + v * dv;
    const R d_error = R(rays.spread[a]) + half * (abs(du) + abs(dv)), least = abs(d) - d_error;
    const R o_error = R(rays.slack[a] + rays.box_slack[a]) + half * (abs(su) + abs(sv));
    const Mask<R> runs = least > R(T(1) / T(64)) * abs(d);
    const R inverse = R(T(1)) / select(runs, d, R(T(1))), error = abs(R(T(1)) / select(runs, least, R(T(1))));
    const R t0 = (R(rays.box_lo[a]) - o) * inverse, t1 = (R(rays.box_hi[a]) - o) * inverse;
    const auto margin = [&](R t) {
      return (o_error + abs(t) * d_error) * (R(T(1) + T(8) * kSpacing<T>) * error) +
             R(T(8) * kSpacing<T>) * abs(t);
    };
    const R in = min(t0, t1), out = max(t0, t1), in_margin = margin(in), out_margin = margin(out);
    range.enters_from = select(runs, max(range.enters_from, in - in_margin), range.enters_from);
    range.enters_to = select(runs, max(range.enters_to, in + in_margin), infinite);
    range.leaves_from = select(runs, min(range.leaves_from, out - out_margin), -infinite);
    range.leaves_to = select(runs, min(range.leaves_to, out + out_margin), range.leaves_to);
  }
  return range;
}

}  // namespace isocast::inline ISO_ISA
