// The first root from one side: what the convex hull of the control polygon leaves empty is cut off.
#pragma once

#include <isocast/implicit/frustum/finder.h>

namespace isocast::inline ISO_ISA {

/// Where the convex hull of the control points first meets zero; past 1 where it never does.
template <Real R> inline R hull_entry(const Bezier<R>& p) {
  using T = Scalar<R>;
  const Mask<R> start = negative(p.c[0]);
  R s = R(2);
  for (int n = 1; n <= p.degree; ++n) {
    const Mask<R> across = negative(p.c[n]) != start;
    if (!any(across)) continue;
    for (int m = 0; m < n; ++m) {
      const R share = p.c[m] / (p.c[m] - p.c[n]);
      const R here = (R(T(m)) + R(T(n - m)) * select(share == share, share, R(0))) / R(T(p.degree));
      s = select(across & (negative(p.c[m]) == start), min(s, here), s);
    }
  }
  return s;
}

/// Ends where the steps have become shorter than eps / 1000 and f changes its sign within eps: a short step
/// alone says nothing near double roots.
///
/// source  Nishita, Sederberg, Kakimoto: Ray tracing trimmed rational surface patches, SIGGRAPH 1990, from
///         one side
template <Real R>
inline FirstRoot<R> find_by_clipping(const Bezier<R>& whole, const FinderOptions& options, R eps,
                                     Mask<R> active) {
  const R short_step = eps * R(Scalar<R>(1e-3)), small_value = eps * eps * whole.largest();
  const Mask<R> start = negative(whole.c[0]);
  FirstRoot<R> root;
  Bezier<R> rest = whole;
  R from = R(0);
  const int most = 8 * options.most;
  for (int step = 0; any(active); ++step) {
    const R entry = hull_entry(rest), left = R(1) - from;
    const Mask<R> passed = active & (negative(rest.c[0]) != start);
    root.settle(passed, from);
    active = active & !passed & (entry <= R(1));
    const R advance = entry * left, x = from + advance;
    Mask<R> stops = abs(rest.c[0]) < small_value;
    if (!options.value) {
      stops = advance < short_step;
      if (any(active & stops)) stops = stops & (negative(rest.at(clamp01(eps / max(left, eps)))) != start);
    }
    root.settle(active & stops, x);
    active = active & !stops;
    if (!any(active)) break;
    if (step == most) {
      root.give_up(active, x);
      break;
    }
    const R share = clamp01(max(entry, short_step / max(left, short_step)));
    Bezier<R> cut = rest;
    cut.keep_right(share);
    assign(rest, active, cut);
    from = select(active, from + share * left, from);
    root.steps = root.steps + select(active, R(1), R(0));
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
