// Affine forms of functions that are not affine: slope * a + offset +- error around them, three ways.
//
// Each rule chooses the slope freely, as nearest arithmetic finds it, and bounds what remains, g(x) - slope
// x, by intervals: so no rounding and no bad choice makes a form wrong. `x` is the part of a's range on which
// g is defined, `y` encloses g there and gives the decorations. Where y is infinite so is the form.
#pragma once

#include <isocast/math/affine.h>

namespace isocast::inline ISO_ISA {

/// slope a + [remainder.lo, remainder.hi], y where that or y is infinite.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> around(const AffineForm<R, N>& a, R slope, const Interval<R>& remainder,
                                      const Interval<R>& y) {
  const AffineForm<R, N> rest(remainder), constant(y);
  const AffineForm<R, N> form = decorated_as(y, mapped(a, slope, rest.c, rest.r));
  const R largest = R(kLargest<Scalar<R>>);
  return select((form.r <= largest) & (y.lo >= -largest) & (y.hi <= largest), form, constant);
}

template <Real R> ISO_HD inline R finite_or_zero(R x) {
  return select(abs(x) <= R(kLargest<Scalar<R>>), x, R(0));
}

/// The smallest interval around both.
template <Real R> ISO_HD inline Interval<R> hull(const Interval<R>& a, const Interval<R>& b) {
  return decorated_as(a, b, min(a.lo, b.lo), max(a.hi, b.hi));
}

/// Chebyshev's approximation of g, convex or concave on x: the slope of the chord; the remainder has one
/// extremum at both ends, the other near u = touch(slope), where g' is the slope. As u is rounded, the
/// tangent there, which the remainder does not cross, bounds it. g and derivative are
/// asked for intervals that are single numbers.
template <Real R, int N, class G, class D, class T>
ISO_HD inline AffineForm<R, N> bent(const AffineForm<R, N>& a, const Interval<R>& x, const Interval<R>& y,
                                    G g, D derivative, T touch) {
  const Interval<R> lo(x.lo), hi(x.hi), at_lo = g(lo), at_hi = g(hi);
  const R chord = finite_or_zero((at_hi.lo - at_lo.lo) / (x.hi - x.lo));
  const Interval<R> slope(chord), u(max(min(touch(chord), x.hi), x.lo));
  const Interval<R> tangent = (g(u) - slope * u) + (derivative(u) - slope) * (Interval<R>(x.lo, x.hi) - u);
  return around(a, chord, hull(hull(at_lo - slope * lo, at_hi - slope * hi), tangent), y);
}

/// The min-range approximation of g, whose derivative on x lies in `slopes`: the slope nearest to zero, so
/// that the remainder is monotone and its ends bound it; none where the slopes differ in sign.
template <Real R, int N, class G>
ISO_HD inline AffineForm<R, N> slanted(const AffineForm<R, N>& a, const Interval<R>& x, const Interval<R>& y,
                                       const Interval<R>& slopes, G g) {
  const R least =
      finite_or_zero(select(slopes.lo > R(0), slopes.lo, select(slopes.hi < R(0), slopes.hi, R(0))));
  const Interval<R> lo(x.lo), hi(x.hi), slope(least);
  const Interval<R> ends = hull(g(lo) - slope * lo, g(hi) - slope * hi);
  return around(a, least, select(least == R(0), y, ends), y);
}

/// Taylor's approximation of g at the middle of x, to second order: `curvature` encloses g'' on x. Where x is
/// so wide that y is much narrower, y.
template <Real R, int N, class G, class D>
ISO_HD inline AffineForm<R, N> curved(const AffineForm<R, N>& a, const Interval<R>& x, const Interval<R>& y,
                                      G g, D derivative, const Interval<R>& curvature) {
  const R middle = R(0.5) * x.lo + R(0.5) * x.hi;
  const Interval<R> m(middle), slopes = derivative(m), away = Interval<R>(x.lo, x.hi) - m;
  const R chosen = finite_or_zero(slopes.lo);
  const Interval<R> slope(chosen), half_square = Interval<R>(R(0.5)) * square(away);
  const Interval<R> remainder = (g(m) - slope * m) + (slopes - slope) * away + curvature * half_square;
  const AffineForm<R, N> form = around(a, chosen, remainder, y), constant(y);
  return select(spread(form) + form.r <= R(2) * constant.r, form, constant);
}

}  // namespace isocast::inline ISO_ISA
