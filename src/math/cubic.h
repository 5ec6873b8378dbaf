// Cubics on [0,1], in Bernstein form (stable) and in powers (the textbook's), and where they turn.
#pragma once

#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

/// p(s) = c0 (1-s)^3 + 3 c1 s (1-s)^2 + 3 c2 s^2 (1-s) + c3 s^3.
template <Real R> struct BernsteinCubic { R c0, c1, c2, c3; };

/// p(s) = a s^3 + b s^2 + c s + d.
template <Real R> struct PowerCubic { R a, b, c, d; };

/// All weights are positive on [0,1]: the error is below 8 unit roundoffs of max |c_i|.
template <Real R> ISO_HD inline R eval(const BernsteinCubic<R>& p, R s) {
  const R r = R(1) - s, ss = s * s;
  return ((p.c0 * r + R(3) * p.c1 * s) * r + R(3) * p.c2 * ss) * r + p.c3 * (ss * s);
}
template <Real R> ISO_HD inline R eval(const PowerCubic<R>& p, R s) {
  return ((p.a * s + p.b) * s + p.c) * s + p.d;
}

/// p(0) and p(1), with the sign of a coefficient that underflowed to -0.
template <Real R> ISO_HD inline R value_at_0(const BernsteinCubic<R>& p) { return p.c0; }
template <Real R> ISO_HD inline R value_at_1(const BernsteinCubic<R>& p) { return p.c3; }
template <Real R> ISO_HD inline R value_at_0(const PowerCubic<R>& p) { return p.d; }
template <Real R> ISO_HD inline R value_at_1(const PowerCubic<R>& p) { return ((p.a + p.b) + p.c) + p.d; }

/// p'(s).
template <Real R> ISO_HD inline R eval_derivative(const BernsteinCubic<R>& p, R s) {
  const R r = R(1) - s;
  const R d0 = p.c1 - p.c0, d1 = p.c2 - p.c1, d2 = p.c3 - p.c2;
  return R(3) * ((d0 * r + R(2) * d1 * s) * r + d2 * (s * s));
}
template <Real R> ISO_HD inline R eval_derivative(const PowerCubic<R>& p, R s) {
  return (R(3) * p.a * s + R(2) * p.b) * s + p.c;
}

/// The same polynomial in powers; digits are lost where coefficients cancel.
template <Real R> ISO_HD inline PowerCubic<R> power_form(const BernsteinCubic<R>& p) {
  return {(p.c3 - p.c0) + R(3) * (p.c1 - p.c2), R(3) * ((p.c0 - p.c1) + (p.c2 - p.c1)), R(3) * (p.c1 - p.c0),
          p.c0};
}

/// Where p' vanishes, in order. What does not exist is NaN or infinite, so `lo < e & e < hi` excludes it.
template <Real R> struct Extrema { R first, second; };

/// From the derivative's Bernstein coefficients, scaled by a power of two, with the quadratic formula that
/// never subtracts nearly equal numbers.
template <Real R> ISO_HD inline Extrema<R> extrema(const BernsteinCubic<R>& p) {
  const R e0 = p.c1 - p.c0, e1 = p.c2 - p.c1, e2 = p.c3 - p.c2;
  const R scale = inverse_power_of_two(max(max(abs(e0), abs(e1)), abs(e2)));
  const R d0 = e0 * scale, d1 = e1 * scale, d2 = e2 * scale;
  // p'/3 = (d0 - 2 d1 + d2) s^2 + 2 (d1 - d0) s + d0, whose discriminant over four is d1^2 - d0 d2
  const R a = (d0 - d1) + (d2 - d1), b = d1 - d0;
  const R q = -(b + copysign(sqrt(d1 * d1 - d0 * d2), b));
  const R x = q / a, y = d0 / q;
  return {min(x, y), max(y, x)};
}

/// As textbooks print it: (-2b +- sqrt(4 b^2 - 12 a c)) / 6a, digits lost for small a and c.
template <Real R> ISO_HD inline Extrema<R> extrema(const PowerCubic<R>& p) {
  const R root = sqrt(R(4) * p.b * p.b - R(12) * p.a * p.c);
  const R x = (R(-2) * p.b - root) / (R(6) * p.a), y = (R(-2) * p.b + root) / (R(6) * p.a);
  const R only = -p.c / (R(2) * p.b);
  const Mask<R> line = p.a == R(0);
  return {select(line, only, min(x, y)), select(line, only, max(y, x))};
}

}  // namespace isocast::inline ISO_ISA
