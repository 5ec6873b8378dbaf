// Affine forms: functions with edges and jumps, and of two operands; the interval's result where no affine
// rule helps.
#pragma once

#include <isocast/math/affine_functions.h>
#include <isocast/math/interval_steps.h>

namespace isocast::inline ISO_ISA {

/// |a| has its extrema beside slope a at the ends and at the edge; a or -a where the sign is known.
template <Real R, int N> ISO_HD inline AffineForm<R, N> abs(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), lo(x.lo), hi(x.hi), y = abs(x);
  const R chord = finite_or_zero((x.hi + x.lo) / (x.hi - x.lo));
  const Interval<R> slope(chord), ends = hull(abs(lo) - slope * lo, abs(hi) - slope * hi);
  const AffineForm<R, N> both = around(a, chord, hull(ends, Interval<R>(R(0))), y);
  return select(not_negative(x), a, select(not_positive(x), -a, both));
}

/// a or b where a - b decides. Else their mean with weights such that the smaller one lies nowhere above it,
/// and below it as far at both ends of a - b.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> min(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  const Interval<R> d = interval_of(a - b);
  const R of_b = d.hi / (d.hi - d.lo), of_a = R(1) - of_b;
  const R below = max(of_b * -d.lo, of_a * d.hi), half = R(0.5) * below;
  AffineForm<R, N> y = a;
  y.c = (of_a * a.c + of_b * b.c) - half;
  each_symbol<N>([&](int k) { y.e[k] = of_a * a.e[k] + of_b * b.e[k]; });
  const R size = abs(a.c) + spread(a) + a.r + abs(b.c) + spread(b) + b.r + half;
  y.r = with_underflow(with_roundings(of_a * a.r + of_b * b.r + half, size, 4));
  return decorated_as(a, b, select(not_positive(d), a, select(not_negative(d), b, settled(y))));
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> max(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return -min(-a, -b);
}

/// By doubling, each square by its own rule; the interval's result where that is much narrower.
template <Real R, int N> ISO_HD inline AffineForm<R, N> chebyshev(const AffineForm<R, N>& a, int n) {
  const AffineForm<R, N> form = chebyshev_by_doubling(a, n), constant(chebyshev(interval_of(a), n));
  return select(spread(form) + form.r <= R(2) * constant.r, form, constant);
}

/// exp(b log(a)) where a is positive, else the interval's result.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> pow(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  const Interval<R> x = interval_of(a), y = pow(x, interval_of(b));
  return decorated_as(y, select(x.lo > R(0), exp(b * log(a)), AffineForm<R, N>(y)));
}

/// sqrt(a^2 + b^2), which is defined everywhere.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> hypot(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return decorated_as(a, b, sqrt(square(a) + square(b)));
}

/// a - b floor(a / b) where that is on one step, else the interval's result.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> mod(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  const Interval<R> x = interval_of(a), z = interval_of(b), quotient = floor(interval_of(a / b)),
                    y = mod(x, z);
  const AffineForm<R, N> form = a - b * AffineForm<R, N>(quotient);
  return select(quotient.continuous, form, AffineForm<R, N>(y));
}

/// a where the condition is not zero, b where it is, both intervals where that is not decided.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> choose(const AffineForm<R, N>& condition, const AffineForm<R, N>& a,
                                      const AffineForm<R, N>& b) {
  const Interval<R> c = interval_of(condition), y = choose(c, interval_of(a), interval_of(b));
  const Mask<R> always = (c.lo > R(0)) | (c.hi < R(0)), never = (c.lo == R(0)) & (c.hi == R(0));
  return decorated_as(y, select(always, a, select(never, b, AffineForm<R, N>(y))));
}

// The interval's result.
template <Real R, int N> ISO_HD inline AffineForm<R, N> sign(const AffineForm<R, N>& a) {
  return AffineForm<R, N>(sign(interval_of(a)));
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> floor(const AffineForm<R, N>& a) {
  return AffineForm<R, N>(floor(interval_of(a)));
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> ceil(const AffineForm<R, N>& a) {
  return AffineForm<R, N>(ceil(interval_of(a)));
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> round(const AffineForm<R, N>& a) {
  return AffineForm<R, N>(round(interval_of(a)));
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> atan2(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return AffineForm<R, N>(atan2(interval_of(a), interval_of(b)));
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> step(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return AffineForm<R, N>(step(interval_of(a), interval_of(b)));
}

}  // namespace isocast::inline ISO_ISA
