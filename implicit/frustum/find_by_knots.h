// The first root by knots: one is inserted at the zero of the control polygon of a spline (MR).
#pragma once

#include <isocast/implicit/frustum/finder.h>

namespace isocast::inline ISO_ISA {

/// A spline over [0, 1] of `degree`, with coefficients c[0..last] and knots t[0..last + degree + 1].
template <Real R, int kMostKnots> struct Spline {
  int degree, last;
  R c[kMostFormDegree + 1 + kMostKnots], t[2 * kMostFormDegree + 2 + kMostKnots];

  explicit Spline(const Bezier<R>& p) : degree(p.degree), last(p.degree) {
    for (int i = 0; i <= last; ++i) {
      c[i] = p.c[i];
      t[i] = R(0);
      t[i + degree + 1] = R(1);
    }
  }
  /// Boehm's rule: coefficients that the knot does not reach have a share of 0 or 1.
  void insert(R x) {
    const int d = degree;
    for (int i = last + 1; i >= 1; --i) {
      R share = R(0);
      if (i <= last) share = clamp01((x - t[i]) / (t[i + d] - t[i]));
      c[i] = i <= last ? (R(1) - share) * c[i - 1] + share * c[i] : c[i - 1];
    }
    const int ends = last + d + 1;
    t[ends + 1] = max(t[ends], x);
    for (int i = ends; i >= 1; --i) t[i] = select(t[i] <= x, t[i], max(t[i - 1], x));
    ++last;
  }
  /// Greville's abscissa of coefficient i.
  R abscissa(int i) const {
    R sum = t[i + 1];
    for (int k = 2; k <= degree; ++k) sum = sum + t[i + k];
    return sum / R(Scalar<R>(degree));
  }
  R slope(int i) const { return (c[i] - c[i - 1]) / (abscissa(i) - abscissa(i - 1)); }
};

/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008; Morken, Reimers: An unconditionally convergent method for computing zeros of splines
///         and polynomials, Mathematics of Computation 76, 2007
template <RootFinder kFinder, Real R>
inline FirstRoot<R> find_by_knots(const Bezier<R>& whole, const FinderOptions& options, R eps,
                                  Mask<R> active) {
  constexpr int kMostKnots = 192;
  const R small_value = eps * eps * whole.largest(), degree = R(Scalar<R>(whole.degree));
  const int most = 3 * options.most;
  FirstRoot<R> root;
  Spline<R, kMostKnots> spline(whole);
  R last_x = R(-1);
  for (int step = 0; any(active); ++step) {
    Mask<R> found = Mask<R>(false);
    R x = R(0), near = R(0), far = R(0), here = R(0), mult = R(1);
    for (int k = 1; k <= spline.last; ++k) {
      const Mask<R> first = active & (negative(spline.c[k - 1]) != negative(spline.c[k])) & !found;
      if (!any(first)) continue;
      found = found | first;
      const R a = spline.c[k - 1], b = spline.c[k], g1 = spline.abscissa(k - 1), g2 = spline.abscissa(k);
      const R share = a / (a - b);
      here = g1 + (g2 - g1) * select(share == share, share, R(0));
      x = select(first, here, x);
      near = select(first, spline.t[k + 1], near);
      far = select(first, spline.t[k + spline.degree - 1], far);
      if constexpr (kFinder == RootFinder::mr_mult) {
        // value and derivatives of the polygon beside the last knot
        const bool inner = spline.last > 1;
        const int low = k > 1 ? k - 1 : 1, high = k < spline.last ? k + 1 : spline.last;
        const R slope = spline.slope(k), before = spline.slope(low), behind = spline.slope(high);
        const R width = spline.abscissa(high) - spline.abscissa(low - 1);
        const R bend = R(2) * (behind - before) / width;
        const R value = select(abs(last_x - g1) < abs(last_x - g2), a, b);
        if (inner) mult = select(first, step_factor(value, slope, bend, degree), mult);
      }
    }
    active = active & found;
    R density = max(abs(x - near), abs(x - far));
    Mask<R> stops = density < eps;
    if (options.value) stops = abs(whole.at(x)) < small_value;
    if (whole.degree == 1) stops = Mask<R>(true);
    root.settle(active & stops, x);
    active = active & !stops;
    if (!any(active)) break;
    if (step == most) {
      root.give_up(active, x);
      break;
    }
    if constexpr (kFinder == RootFinder::mr_mult) {
      const R longer = last_x + mult * (x - last_x);
      const Mask<R> inside = (last_x >= R(0)) & (longer > R(0)) & (longer < R(1));
      x = select(inside, longer, x);
    }
    last_x = x;
    spline.insert(x);
    root.steps = root.steps + select(active, R(1), R(0));
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
