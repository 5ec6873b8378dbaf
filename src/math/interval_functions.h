// Intervals: exponentials, logarithms, hyperbolic functions and the inverse ones of angles, which are
// monotone.
#pragma once

#include <isocast/math/elementary.h>
#include <isocast/math/interval.h>

namespace isocast::inline ISO_ISA {

/// pi, as an interval.
template <Real R> ISO_HD inline Interval<R> pi_interval() { return enclosed<R>(0x1.921fb54442d18p+1, false); }

/// f(a) for f that rises and whose library function gives `lo` and `hi` at the ends of a.
template <Real R> ISO_HD inline Interval<R> rising(const Interval<R>& a, R lo, R hi) {
  return decorated_as(a, down_library(lo), up_library(hi));
}

template <Real R> ISO_HD inline Interval<R> exp(const Interval<R>& a) {
  return cut(rising(a, exp(a.lo), exp(a.hi)), R(0), R(kInfinity<Scalar<R>>));
}

/// Of a number, with one call of the library.
template <Real R> ISO_HD inline Interval<R> exp_at(R x) {
  const R y = exp(x);
  return Interval<R>(max(down_library(y), R(0)), up_library(y));
}
/// The same for x >= 0.
template <Real R> ISO_HD inline Interval<R> log_at(R x) {
  const R y = log(x);
  return Interval<R>(down_library(y), up_library(y));
}

/// Of the part that is positive; undefined where there is another, empty without one.
template <Real R> ISO_HD inline Interval<R> log(const Interval<R>& a) {
  const Interval<R> y = rising(a, log(max(a.lo, R(0))), log(max(a.hi, R(0))));
  return limited(y, a.lo > R(0), a.hi <= R(0));
}
template <Real R> ISO_HD inline Interval<R> log10(const Interval<R>& a) {
  const Interval<R> y = rising(a, log10(max(a.lo, R(0))), log10(max(a.hi, R(0))));
  return limited(y, a.lo > R(0), a.hi <= R(0));
}

/// The largest argument up to which the library keeps its error bound for sinh and cosh.
template <class T> inline constexpr T kHyperbolicRange = sizeof(T) == 4 ? T(88.5) : T(709);

/// Beyond the library's range the value there bounds one side, nothing the other.
template <Real R> ISO_HD inline Interval<R> sinh(const Interval<R>& a) {
  using T = Scalar<R>;
  const R range = R(kHyperbolicRange<T>), all = R(kInfinity<T>);
  const Interval<R> x = cut(a, -range, range), y = rising(a, sinh(x.lo), sinh(x.hi));
  return decorated_as(a, select(a.lo < -range, -all, y.lo), select(a.hi > range, all, y.hi));
}
template <Real R> ISO_HD inline Interval<R> cosh(const Interval<R>& a) {
  using T = Scalar<R>;
  const R range = R(kHyperbolicRange<T>), all = R(kInfinity<T>);
  const Interval<R> m = abs(a), x = cut(m, R(0), range), y = rising(a, cosh(x.lo), cosh(x.hi));
  return decorated_as(a, max(y.lo, R(1)), select(m.hi > range, all, y.hi));
}
template <Real R> ISO_HD inline Interval<R> tanh(const Interval<R>& a) {
  return cut(rising(a, tanh(a.lo), tanh(a.hi)), R(-1), R(1));
}

/// Of the part in [-1, 1]; undefined where there is another, empty without one.
template <Real R> ISO_HD inline Interval<R> asin(const Interval<R>& a) {
  const Interval<R> x = cut(a, R(-1), R(1));
  return limited(rising(a, asin(x.lo), asin(x.hi)), (a.lo >= R(-1)) & (a.hi <= R(1)),
                 (a.lo > R(1)) | (a.hi < R(-1)));
}
template <Real R> ISO_HD inline Interval<R> acos(const Interval<R>& a) {
  const Interval<R> x = cut(a, R(-1), R(1)), y = rising(a, acos(x.hi), acos(x.lo));
  return limited(decorated_as(a, max(y.lo, R(0)), y.hi), (a.lo >= R(-1)) & (a.hi <= R(1)),
                 (a.lo > R(1)) | (a.hi < R(-1)));
}
template <Real R> ISO_HD inline Interval<R> atan(const Interval<R>& a) {
  return rising(a, atan(a.lo), atan(a.hi));
}

}  // namespace isocast::inline ISO_ISA
