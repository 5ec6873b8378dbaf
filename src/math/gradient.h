// Values with their three partial derivatives, by forward differentiation.
#pragma once

#include <isocast/math/affine_choices.h>

namespace isocast::inline ISO_ISA {

/// f and df/dx, df/dy, df/dz at a point, or inclusions of them over a box. F: a Real, an Interval or an
/// AffineForm. The derivatives' decorations say where they exist; at an edge (of abs, min, max, choose) an
/// inclusion of a derivative holds those of both sides, is defined and not continuous; beside a jump it is
/// undefined.
template <class F> struct Gradient {
  F value, dx, dy, dz;

  Gradient() = default;
  ISO_HD Gradient(const F& v, const F& x, const F& y, const F& z) : value(v), dx(x), dy(y), dz(z) {}
  /// A constant.
  ISO_HD explicit Gradient(const F& v) : Gradient(v, F(0), F(0), F(0)) {}
  ISO_HD explicit Gradient(int v) : Gradient(F(v)) {}
};

/// The kind of number that F is made of.
template <Real R> ISO_HD inline R whole_number(int n, R) { return R(static_cast<Scalar<R>>(n)); }
template <Real R> ISO_HD inline Interval<R> whole_number(int n, Interval<R>) { return enclosed<R>(n, true); }
template <Real R, int N> ISO_HD inline AffineForm<R, N> whole_number(int n, AffineForm<R, N>) {
  return AffineForm<R, N>(enclosed<R>(n, true));
}

/// 0, the derivative of a function in steps: where `value` may jump it does not exist.
template <Real R> ISO_HD inline R flat_derivative(R value) { return value - value; }
template <Real R> ISO_HD inline Interval<R> flat_derivative(const Interval<R>& value) {
  return limited(decorated_as(value, R(0), R(0)), value.continuous, Mask<R>(false));
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> flat_derivative(const AffineForm<R, N>& value) {
  return AffineForm<R, N>(flat_derivative(interval_of(value)));
}

/// g(a), whose value and derivative at a.value are given: the chain rule.
template <class F> ISO_HD inline Gradient<F> chained(const Gradient<F>& a, const F& value, const F& slope) {
  return {value, slope * a.dx, slope * a.dy, slope * a.dz};
}
/// g(a, b) likewise.
template <class F>
ISO_HD inline Gradient<F> chained(const Gradient<F>& a, const Gradient<F>& b, const F& value,
                                  const F& slope_a, const F& slope_b) {
  return {value, slope_a * a.dx + slope_b * b.dx, slope_a * a.dy + slope_b * b.dy,
          slope_a * a.dz + slope_b * b.dz};
}

template <class F> ISO_HD inline Gradient<F> operator-(const Gradient<F>& a) {
  return {-a.value, -a.dx, -a.dy, -a.dz};
}
template <class F> ISO_HD inline Gradient<F> operator+(const Gradient<F>& a, const Gradient<F>& b) {
  return {a.value + b.value, a.dx + b.dx, a.dy + b.dy, a.dz + b.dz};
}
template <class F> ISO_HD inline Gradient<F> operator-(const Gradient<F>& a, const Gradient<F>& b) {
  return {a.value - b.value, a.dx - b.dx, a.dy - b.dy, a.dz - b.dz};
}
template <class F> ISO_HD inline Gradient<F> operator*(const Gradient<F>& a, const Gradient<F>& b) {
  return chained(a, b, a.value * b.value, b.value, a.value);
}
template <class F> ISO_HD inline Gradient<F> operator/(const Gradient<F>& a, const Gradient<F>& b) {
  const F quotient = a.value / b.value, inverse = F(1) / b.value;
  return chained(a, b, quotient, inverse, -(quotient * inverse));
}
template <class F> ISO_HD inline Gradient<F> square(const Gradient<F>& a) {
  return chained(a, square(a.value), F(2) * a.value);
}
template <class F> ISO_HD inline Gradient<F> power(const Gradient<F>& a, int n) {
  if (n == 0) return chained(a, power(a.value, 0), flat_derivative(power(a.value, 0)));
  return chained(a, power(a.value, n), whole_number(n, F(0)) * power(a.value, n - 1));
}

/// a where the condition is not 0, else b, with the derivatives of the same side.
template <class F>
ISO_HD inline Gradient<F> choose(const Gradient<F>& condition, const Gradient<F>& a, const Gradient<F>& b) {
  const F& c = condition.value;
  return {choose(c, a.value, b.value), choose(c, a.dx, b.dx), choose(c, a.dy, b.dy), choose(c, a.dz, b.dz)};
}
template <class F> ISO_HD inline Gradient<F> step(const Gradient<F>& edge, const Gradient<F>& a) {
  const F value = step(edge.value, a.value), slope = flat_derivative(value);
  return chained(edge, a, value, slope, slope);
}
template <class F> ISO_HD inline Gradient<F> abs(const Gradient<F>& a) {
  Gradient<F> y = choose(step(Gradient<F>(0), a), a, -a);
  y.value = abs(a.value);
  return y;
}
template <class F> ISO_HD inline Gradient<F> min(const Gradient<F>& a, const Gradient<F>& b) {
  Gradient<F> y = choose(step(a, b), a, b);
  y.value = min(a.value, b.value);
  return y;
}
template <class F> ISO_HD inline Gradient<F> max(const Gradient<F>& a, const Gradient<F>& b) {
  Gradient<F> y = choose(step(b, a), a, b);
  y.value = max(a.value, b.value);
  return y;
}
template <class F> ISO_HD inline Gradient<F> chebyshev(const Gradient<F>& a, int n) {
  Gradient<F> y = chebyshev_by_doubling(a, n);
  y.value = chebyshev(a.value, n);
  return y;
}

}  // namespace isocast::inline ISO_ISA
