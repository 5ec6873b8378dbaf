// Intervals: squares, integer and real powers, roots.
#pragma once

#include <isocast/math/bits.h>
#include <isocast/math/elementary.h>
#include <isocast/math/interval.h>

namespace isocast::inline ISO_ISA {

template <Real R> ISO_HD inline Interval<R> square(const Interval<R>& a) {
  const Interval<R> m = abs(a);
  return decorated_as(a, max(down(m.lo * m.lo), R(0)), up(m.hi * m.hi));
}

/// A bound of x^n for x >= 0, n > 0 by repeated squaring, each product rounded: an upper one where `above`.
template <Real R> ISO_HD inline R power_bound(R x, unsigned n, Mask<R> above) {
  const auto product = [above](R a, R b) { return select(above, up(a * b), max(down(a * b), R(0))); };
  R p = x;
  for (unsigned bit = (1u << highest_bit(n)) >> 1; bit != 0; bit >>= 1) {
    p = product(p, p);
    if (n & bit) p = product(p, x);
  }
  return p;
}

/// a^n for any integer n: even powers from |a|, odd ones end by end, 1 for n = 0, 1 / a^-n for n < 0 with the
/// rules of the division. Knoll et al. 2009.
template <Real R> ISO_HD inline Interval<R> power(const Interval<R>& a, int n) {
  if (n == 0) return decorated_as(a, R(1), R(1));
  const unsigned exponent = n < 0 ? 0u - static_cast<unsigned>(n) : static_cast<unsigned>(n);
  const bool odd = exponent & 1;
  const Interval<R> x = odd ? a : abs(a);
  const Mask<R> lo_negative = x.lo < R(0), hi_negative = x.hi < R(0);
  const R lo = power_bound(abs(x.lo), exponent, lo_negative),
          hi = power_bound(abs(x.hi), exponent, !hi_negative);
  const Interval<R> p = decorated_as(a, select(lo_negative, -lo, lo), select(hi_negative, -hi, hi));
  return n < 0 ? Interval<R>(R(1)) / p : p;
}

/// Of the part that is not negative; undefined where there is another, empty without one.
template <Real R> ISO_HD inline Interval<R> sqrt(const Interval<R>& a) {
  const R lo = sqrt(max(a.lo, R(0))), hi = sqrt(max(a.hi, R(0)));
  return limited(decorated_as(a, down_exact_zero(lo), up_exact_zero(hi)), a.lo >= R(0), a.hi < R(0));
}

template <Real R> ISO_HD inline Interval<R> cbrt(const Interval<R>& a) {
  return decorated_as(a, down_library(cbrt(a.lo)), up_library(cbrt(a.hi)));
}

/// sqrt(a^2 + b^2). Squares that over- or underflow make it wide, never wrong.
template <Real R> ISO_HD inline Interval<R> hypot(const Interval<R>& a, const Interval<R>& b) {
  return sqrt(square(a) + square(b));
}

/// a^b, b real: for a > 0; for a = 0 where b > 0; for a < 0 where b is an integer. The part of a that is
/// positive takes its ends at those of a and b. A negative part adds -m to m, m its largest value, where b
/// holds an integer. Undefined where a may be negative and b is not one integer, or a zero and b not
/// positive.
template <Real R> ISO_HD inline Interval<R> pow(const Interval<R>& a, const Interval<R>& b) {
  const R lo = max(a.lo, R(0)), hi = max(a.hi, R(0));
  const R p = pow(lo, b.lo), q = pow(lo, b.hi), r = pow(hi, b.lo), s = pow(hi, b.hi);
  const R low = max(down_library(min(min(p, q), min(r, s))), R(0)),
          high = up_library(max(max(p, q), max(r, s)));
  const R far = max(-a.lo, R(0)), near = max(-a.hi, R(0));
  const R m = up_library(max(max(pow(far, b.lo), pow(far, b.hi)), max(pow(near, b.lo), pow(near, b.hi))));
  const Mask<R> left = a.lo < R(0), whole = left & (floor(b.hi) >= b.lo), single = whole & (b.lo == b.hi);
  const Mask<R> outside = (left & !single) | (holds_zero(a) & (b.lo <= R(0)));
  const Interval<R> y =
      decorated_as(a, b, select(whole, min(low, -m), low), select(whole, max(high, m), high));
  return limited(y, !outside, (a.hi < R(0)) & !whole);
}

}  // namespace isocast::inline ISO_ISA
