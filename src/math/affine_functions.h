// Affine forms: functions that are smooth where they are defined.
#pragma once

#include <isocast/math/affine_rules.h>
#include <isocast/math/interval_angles.h>
#include <isocast/math/interval_powers.h>

namespace isocast::inline ISO_ISA {

/// Chebyshev; undefined, and of the part that is not negative, where there is another. Beside the chord's
/// slope 1 / (p + q) between the roots p and q of the ends the square root lies between p q / (p + q), at
/// both ends, and (p + q) / 4.
template <Real R, int N> ISO_HD inline AffineForm<R, N> sqrt(const AffineForm<R, N>& a) {
  const Interval<R> y = sqrt(interval_of(a));
  const R sum = y.lo + y.hi, slope = R(1) / sum, least = y.lo * (y.hi * slope), most = R(0.25) * sum;
  const R error = with_roundings(R(0.5) * max(most - least, R(0)), y.hi, 12);
  const R largest = R(kLargest<Scalar<R>>);
  return select((y.hi <= largest) & (slope <= largest),
                decorated_as(y, mapped(a, slope, R(0.5) * (least + most), error)), AffineForm<R, N>(y));
}

/// Chebyshev.
template <Real R, int N> ISO_HD inline AffineForm<R, N> exp(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a);
  const auto g = [](const Interval<R>& u) { return exp_at(u.lo); };
  return bent(a, x, exp(x), g, g, [](R slope) { return log(slope); });
}

/// Chebyshev; infinite where a may be zero, as on the negative side, where it is undefined.
template <Real R, int N> ISO_HD inline AffineForm<R, N> log(const AffineForm<R, N>& a) {
  const Interval<R> range = interval_of(a), x = cut(range, R(0), R(kInfinity<Scalar<R>>));
  return bent(
      a, x, log(range), [](const Interval<R>& u) { return log_at(u.lo); },
      [](const Interval<R>& u) { return Interval<R>(R(1)) / u; }, [](R slope) { return R(1) / slope; });
}
/// log(a) / log(10).
template <Real R, int N> ISO_HD inline AffineForm<R, N> log10(const AffineForm<R, N>& a) {
  return log(a) * AffineForm<R, N>(enclosed<R>(0x1.bcb7b1526e50ep-2, false));
}

/// 1 / a. Chebyshev; nothing is known where a may be zero, which is undefined.
template <Real R, int N> ISO_HD inline AffineForm<R, N> reciprocal(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), one(R(1));
  return bent(
      a, x, one / x, [](const Interval<R>& u) { return Interval<R>(R(1)) / u; },
      [](const Interval<R>& u) { return -(Interval<R>(R(1)) / square(u)); },
      [&x](R slope) { return copysign(R(1) / sqrt(-slope), x.lo); });
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> operator/(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return a * reciprocal(b);
}

/// a^n for even n > 2: the tangent at the middle m, above which a^n lies by at most what it does at an end,
/// (|m| + rho)^n - |m|^n - n |m|^(n-1) rho with the radius rho. To second order as good as Chebyshev's.
template <Real R, int N> ISO_HD inline AffineForm<R, N> even_power(const AffineForm<R, N>& a, int n) {
  const Interval<R> x = interval_of(a), m(abs(a.c)), count = enclosed<R>(n, true);
  const Interval<R> end(max(abs(x.lo), abs(x.hi))), slope = count * power(m, n - 1), at_middle = power(m, n);
  const R above = max((power(end, n) - at_middle - slope * (end - m)).hi, R(0)), half = R(0.5) * above;
  const Interval<R> offset = at_middle - slope * m + Interval<R>(half);
  const AffineForm<R, N> rest(offset);
  AffineForm<R, N> y = mapped(a, copysign(slope.lo, a.c), rest.c, half + rest.r);
  const Interval<R> range = power(x, n);
  y.r = y.r + (slope.hi - slope.lo) * (abs(x.lo) + abs(x.hi));
  return select(range.hi <= R(kLargest<Scalar<R>>), decorated_as(range, settled(y)), AffineForm<R, N>(range));
}

/// a^4 by the same rule, written out.
template <Real R, int N> ISO_HD inline AffineForm<R, N> fourth_power(const AffineForm<R, N>& a) {
  AffineForm<R, N> y = a;
  const R size = abs(a.c), square = a.c * a.c, radius = spread(a) + a.r, slope = R(4) * (size * square);
  const R half = R(0.5) * (radius * radius * (R(6) * square + radius * (R(4) * size + radius)));
  y.c = square * square + half;
  each_symbol<N>([&](int k) { y.e[k] = copysign(slope, a.c) * a.e[k]; });
  y.r = with_underflow(with_roundings(slope * a.r + half, y.c + slope * radius, 4));
  return settled(y);
}

/// a^n for any integer n: an odd power is a times an even one, a negative one a reciprocal.
template <Real R, int N> ISO_HD inline AffineForm<R, N> power(const AffineForm<R, N>& a, int n) {
  if (n < -__INT_MAX__) return AffineForm<R, N>(power(interval_of(a), n));
  if (n < 0) return reciprocal(power(a, -n));
  if (n == 0) return decorated_as(interval_of(a), AffineForm<R, N>(R(1)));
  if (n == 1) return a;
  if (n == 2) return square(a);
  if (n == 4) return fourth_power(a);
  return n % 2 ? a * power(a, n - 1) : even_power(a, n);
}

/// g(a) for a sine g of any phase, with `value` and `slope` the library's g and g' at a's middle. Taylor: g''
/// is -g, and g lies within abs(slope) rho + rho^2 / 2 of `value` over the radius rho. That alone for wide
/// angles, [-1, 1] for those beyond the library's range.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> wave_form(const AffineForm<R, N>& a, R value, R slope) {
  using T = Scalar<R>;
  constexpr T kSpacings = T(2) * kLibraryUlps<T> + T(4);
  const R radius = raised(spread(a) + a.r), bend = R(0.5) * (radius * radius), rise = abs(slope) * radius;
  const R size = abs(value) + rise + bend,
          away = with_roundings(rise + bend, size, kSpacings) + R(kSpacings * kSmallest<T>);
  const Mask<R> far = !(abs(a.c) <= R(kAngleRange<T>));
  const R lo = select(far, R(-1), max(value - away, R(-1))), hi = select(far, R(1), min(value + away, R(1)));
  const AffineForm<R, N> range(decorated_as(interval_of(a), lo, hi));

  const R below = bend * max(hi, R(0)), above = bend * max(-lo, R(0));
  AffineForm<R, N> y = range;
  y.c = value + R(0.5) * (above - below);
  each_symbol<N>([&](int k) { y.e[k] = slope * a.e[k]; });
  y.r = with_roundings(abs(slope) * a.r + R(0.5) * (above + below), size, kSpacings) +
        R(T(12) * kSpacings * kSmallest<T>);
  y = settled(y);
  return select((!far) & (spread(y) + y.r <= R(2) * range.r), y, range);
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> sin(const AffineForm<R, N>& a) {
  return wave_form(a, sin(a.c), cos(a.c));
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> cos(const AffineForm<R, N>& a) {
  return wave_form(a, cos(a.c), -sin(a.c));
}

/// Min-range; nothing is known where there may be a pole, which is undefined.
template <Real R, int N> ISO_HD inline AffineForm<R, N> tan(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), y = tan(x);
  return slanted(a, x, y, Interval<R>(R(1)) + square(y), [](const Interval<R>& u) { return tan(u); });
}

/// Min-range.
template <Real R, int N> ISO_HD inline AffineForm<R, N> cbrt(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), y = cbrt(x);
  return slanted(a, x, y, Interval<R>(R(1)) / (Interval<R>(R(3)) * square(y)),
                 [](const Interval<R>& u) { return cbrt(u); });
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> sinh(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a);
  return slanted(a, x, sinh(x), cosh(x), [](const Interval<R>& u) { return sinh(u); });
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> tanh(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), y = tanh(x);
  return slanted(a, x, y, Interval<R>(R(1)) - square(y), [](const Interval<R>& u) { return tanh(u); });
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> atan(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a), one(R(1));
  return slanted(a, x, atan(x), one / (one + square(x)), [](const Interval<R>& u) { return atan(u); });
}
/// Min-range; undefined, and of the part in [-1, 1], where there is another.
template <Real R, int N> ISO_HD inline AffineForm<R, N> asin(const AffineForm<R, N>& a) {
  const Interval<R> range = interval_of(a), x = cut(range, R(-1), R(1)), one(R(1));
  return slanted(a, x, asin(range), one / sqrt(one - square(x)),
                 [](const Interval<R>& u) { return asin(u); });
}
/// pi / 2 - asin(a).
template <Real R, int N> ISO_HD inline AffineForm<R, N> acos(const AffineForm<R, N>& a) {
  return AffineForm<R, N>(enclosed<R>(0x1.921fb54442d18p+0, false)) - asin(a);
}

/// Chebyshev.
template <Real R, int N> ISO_HD inline AffineForm<R, N> cosh(const AffineForm<R, N>& a) {
  const Interval<R> x = interval_of(a);
  return bent(
      a, x, cosh(x), [](const Interval<R>& u) { return cosh(u); },
      [](const Interval<R>& u) { return sinh(u); },
      [](R slope) { return copysign(log(abs(slope) + sqrt(slope * slope + R(1))), slope); });
}

}  // namespace isocast::inline ISO_ISA
