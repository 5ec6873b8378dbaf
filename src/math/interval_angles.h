// Intervals: functions of angles, and the angle of a point.
#pragma once

#include <isocast/math/interval_functions.h>

namespace isocast::inline ISO_ISA {

/// The largest angle up to which the library keeps its error bound.
template <class T> inline constexpr T kAngleRange = sizeof(T) == 4 ? T(5e9) : T(1e14);

/// a / (2 pi).
template <Real R> ISO_HD inline Interval<R> turns(const Interval<R>& a) {
  return a * enclosed<R>(0x1.45f306dc9c883p-3, false);
}

/// `turns` (+ `shift`, exact) may hold an integer; so it may where a is beyond the library's range.
template <Real R>
ISO_HD inline Mask<R> may_hold_integer(const Interval<R>& a, const Interval<R>& turns, Scalar<R> shift) {
  using T = Scalar<R>;
  const Interval<R> t = turns + Interval<R>(R(shift));
  return (floor(t.hi) >= t.lo) | (a.lo < R(-kAngleRange<T>)) | (a.hi > R(kAngleRange<T>));
}

/// A wave of height 1 with a crest where `top` and a trough where `bottom`, with values p, q at the ends of
/// a.
template <Real R>
ISO_HD inline Interval<R> wave(const Interval<R>& a, R p, R q, Mask<R> top, Mask<R> bottom) {
  const R lo = max(down_library(min(p, q)), R(-1)), hi = min(up_library(max(p, q)), R(1));
  return decorated_as(a, select(bottom, R(-1), lo), select(top, R(1), hi));
}

/// Crests and troughs are looked for among multiples of pi/2, rounded outward: [-1, 1] when in doubt, as for
/// angles beyond about 1 / (8 spacings). Knoll et al. 2009.
template <Real R> ISO_HD inline Interval<R> sin(const Interval<R>& a) {
  using T = Scalar<R>;
  const Interval<R> t = turns(a);
  return wave(a, sin(a.lo), sin(a.hi), may_hold_integer(a, t, T(-0.25)), may_hold_integer(a, t, T(0.25)));
}
template <Real R> ISO_HD inline Interval<R> cos(const Interval<R>& a) {
  using T = Scalar<R>;
  const Interval<R> t = turns(a);
  return wave(a, cos(a.lo), cos(a.hi), may_hold_integer(a, t, T(0)), may_hold_integer(a, t, T(0.5)));
}

/// The same of a number, with one call of the library.
template <Real R> ISO_HD inline Interval<R> wave_at(R x, R value) {
  const Mask<R> far = abs(x) > R(kAngleRange<Scalar<R>>);
  return Interval<R>(select(far, R(-1), max(down_library(value), R(-1))),
                     select(far, R(1), min(up_library(value), R(1))));
}
template <Real R> ISO_HD inline Interval<R> sin_at(R x) { return wave_at(x, sin(x)); }
template <Real R> ISO_HD inline Interval<R> cos_at(R x) { return wave_at(x, cos(x)); }

/// Rises between poles; all numbers and undefined where there may be a pole.
template <Real R> ISO_HD inline Interval<R> tan(const Interval<R>& a) {
  using T = Scalar<R>;
  const Interval<R> t = turns(a);
  const Mask<R> pole = may_hold_integer(a, t + t, T(0.5));
  const Interval<R> y = rising(a, tan(a.lo), tan(a.hi));
  const R all = R(kInfinity<T>);
  return limited(decorated_as(a, select(pole, -all, y.lo), select(pole, all, y.hi)), !pole, Mask<R>(false));
}

/// The angle of (x, y) in [-pi, pi], 0 at the origin: from the two corners of the box that are seen under the
/// smallest and the largest angle. [-pi, pi] and not continuous where the box meets the cut, y < 0 beside
/// y >= 0 with x < 0; not continuous at the origin.
template <Real R> ISO_HD inline Interval<R> atan2(const Interval<R>& y, const Interval<R>& x) {
  const R zero = R(0), ylo = y.lo + zero, yhi = y.hi + zero;  // -0 would be the other side of the cut
  const R xlo = x.lo + zero, xhi = x.hi + zero;
  const Mask<R> above = ylo >= zero, below = yhi < zero;
  const R first = atan2(select(above, select(xhi > zero, ylo, yhi), select(xlo >= zero, ylo, yhi)),
                        select(above, xhi, xlo));
  const R last = atan2(select(below, select(xhi > zero, yhi, ylo), select(xlo >= zero, yhi, ylo)),
                       select(below, xhi, xlo));
  const Mask<R> cut = (!above) & (!below) & (xlo < zero), origin = holds_zero(x) & holds_zero(y);
  const Interval<R> pi = pi_interval<R>();
  const R lo = select(origin, min(down_library(first), zero), down_library(first));
  const R hi = select(origin, max(up_library(last), zero), up_library(last));
  return continuous_where(decorated_as(y, x, select(cut, -pi.hi, lo), select(cut, pi.hi, hi)),
                          !(cut | origin));
}

/// A bound on the Chebyshev polynomial T_n beyond 1, where it and its recurrence only rise: T_n of the point
/// x.
template <Real R> ISO_HD inline Interval<R> chebyshev_beyond_1(R x, int n) {
  const Interval<R> slope = Interval<R>(R(2)) * (Interval<R>(x) - Interval<R>(R(1)));
  Interval<R> value(x), difference = value - Interval<R>(R(1));
  for (int k = 1; k < n; ++k) {
    difference = slope * value + difference;
    value = value + difference;
  }
  return value;
}

/// The Chebyshev polynomial T_n(a), n >= 0: cos(n acos(a)) of the part in [-1, 1], and beyond it, where T_n
/// is monotone, the ends.
template <Real R> ISO_HD inline Interval<R> chebyshev(const Interval<R>& a, int n) {
  if (n == 0) return decorated_as(a, R(1), R(1));
  const R one = R(1);
  const Interval<R> inner = cos(enclosed<R>(n, true) * acos(cut(a, -one, one)));
  const Mask<R> on_right = a.hi > one, on_left = a.lo < -one, inside = (a.lo <= one) & (a.hi >= -one);
  // of numbers that are at least 1 in size, from `least` to `most`
  const auto beyond = [&](Mask<R> there, R least, R most) {
    Interval<R> y(one);
    if (any(there)) y = chebyshev_beyond_1(max(most, one), n);
    const Mask<R> apart = least > one;
    y.lo = any(apart) ? select(apart, chebyshev_beyond_1(max(least, one), n).lo, one) : one;
    return y;
  };
  const Interval<R> right = beyond(on_right, a.lo, a.hi), left = beyond(on_left, -a.hi, -a.lo),
                    mirrored = n % 2 ? -left : left;
  R lo = select(inside, inner.lo, R(kInfinity<Scalar<R>>)), hi = select(inside, inner.hi, -lo);
  lo = select(on_right, min(lo, right.lo), lo), hi = select(on_right, max(hi, right.hi), hi);
  lo = select(on_left, min(lo, mirrored.lo), lo), hi = select(on_left, max(hi, mirrored.hi), hi);
  return decorated_as(a, lo, hi);
}

}  // namespace isocast::inline ISO_ISA
