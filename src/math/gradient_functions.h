// Gradients of the library's functions, by the chain rule.
#pragma once

#include <isocast/math/gradient.h>

namespace isocast::inline ISO_ISA {

template <class F> ISO_HD inline Gradient<F> sqrt(const Gradient<F>& a) {
  const F y = sqrt(a.value);
  return chained(a, y, F(1) / (F(2) * y));
}
template <class F> ISO_HD inline Gradient<F> cbrt(const Gradient<F>& a) {
  const F y = cbrt(a.value);
  return chained(a, y, F(1) / (F(3) * square(y)));
}
template <class F> ISO_HD inline Gradient<F> exp(const Gradient<F>& a) {
  const F y = exp(a.value);
  return chained(a, y, y);
}
template <class F> ISO_HD inline Gradient<F> log(const Gradient<F>& a) {
  return chained(a, log(a.value), F(1) / a.value);
}
template <class F> ISO_HD inline Gradient<F> log10(const Gradient<F>& a) {
  return chained(a, log10(a.value), F(1) / (log(F(10)) * a.value));
}
template <class F> ISO_HD inline Gradient<F> sin(const Gradient<F>& a) {
  return chained(a, sin(a.value), cos(a.value));
}
template <class F> ISO_HD inline Gradient<F> cos(const Gradient<F>& a) {
  return chained(a, cos(a.value), -sin(a.value));
}
template <class F> ISO_HD inline Gradient<F> tan(const Gradient<F>& a) {
  const F y = tan(a.value);
  return chained(a, y, F(1) + square(y));
}
template <class F> ISO_HD inline Gradient<F> asin(const Gradient<F>& a) {
  return chained(a, asin(a.value), F(1) / sqrt(F(1) - square(a.value)));
}
template <class F> ISO_HD inline Gradient<F> acos(const Gradient<F>& a) {
  return chained(a, acos(a.value), -(F(1) / sqrt(F(1) - square(a.value))));
}
template <class F> ISO_HD inline Gradient<F> atan(const Gradient<F>& a) {
  return chained(a, atan(a.value), F(1) / (F(1) + square(a.value)));
}
template <class F> ISO_HD inline Gradient<F> sinh(const Gradient<F>& a) {
  return chained(a, sinh(a.value), cosh(a.value));
}
template <class F> ISO_HD inline Gradient<F> cosh(const Gradient<F>& a) {
  return chained(a, cosh(a.value), sinh(a.value));
}
template <class F> ISO_HD inline Gradient<F> tanh(const Gradient<F>& a) {
  const F y = tanh(a.value);
  return chained(a, y, F(1) - square(y));
}
template <class F> ISO_HD inline Gradient<F> sign(const Gradient<F>& a) {
  const F y = sign(a.value);
  return chained(a, y, flat_derivative(y));
}
template <class F> ISO_HD inline Gradient<F> floor(const Gradient<F>& a) {
  const F y = floor(a.value);
  return chained(a, y, flat_derivative(y));
}
template <class F> ISO_HD inline Gradient<F> ceil(const Gradient<F>& a) {
  const F y = ceil(a.value);
  return chained(a, y, flat_derivative(y));
}
template <class F> ISO_HD inline Gradient<F> round(const Gradient<F>& a) {
  const F y = round(a.value);
  return chained(a, y, flat_derivative(y));
}

template <class F> ISO_HD inline Gradient<F> pow(const Gradient<F>& a, const Gradient<F>& b) {
  const F y = pow(a.value, b.value);
  return chained(a, b, y, b.value * pow(a.value, b.value - F(1)), y * log(a.value));
}
/// The angle of (x, y).
template <class F> ISO_HD inline Gradient<F> atan2(const Gradient<F>& y, const Gradient<F>& x) {
  const F inverse = F(1) / (square(x.value) + square(y.value));
  return chained(y, x, atan2(y.value, x.value), x.value * inverse, -(y.value * inverse));
}
template <class F> ISO_HD inline Gradient<F> hypot(const Gradient<F>& a, const Gradient<F>& b) {
  return sqrt(square(a) + square(b));
}
template <class F> ISO_HD inline Gradient<F> mod(const Gradient<F>& a, const Gradient<F>& b) {
  return a - b * floor(a / b);
}

}  // namespace isocast::inline ISO_ISA
