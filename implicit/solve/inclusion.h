// What a formula's tape may be run on to enclose it, and how a part of a ray becomes its argument.
#pragma once

#include <isocast/implicit/expression/evaluate.h>
#include <isocast/math/affine_functions.h>
#include <isocast/math/gradient_functions.h>
#include <isocast/math/interval_functions.h>

namespace isocast::inline ISO_ISA {

template <Real R> ISO_HD inline Interval<R> constant_as(TapeConstant c, const Interval<R>&) {
  return enclosed<R>(c.value, c.exact);
}
/// Cheap, as it is done at every run of a tape.
template <Real R, int N> ISO_HD inline AffineForm<R, N> constant_as(TapeConstant c, const AffineForm<R, N>&) {
  using T = Scalar<R>;
  const T x = static_cast<T>(c.value);
  if (!(abs(x) <= kLargest<T>)) return AffineForm<R, N>(enclosed<R>(c.value, c.exact));
  AffineForm<R, N> y;
  y.c = R(x);
  each_symbol<N>([&y](int k) { y.e[k] = R(0); });
  const bool rounded = !c.exact || static_cast<double>(x) != c.value;
  y.r = R(kOutward && rounded ? kSpacing<T> * abs(x) + kSmallest<T> : T(0));
  y.defined = y.continuous = Mask<R>(true);
  y.empty = Mask<R>(false);
  return y;
}
template <class F> ISO_HD inline Gradient<F> constant_as(TapeConstant c, const Gradient<F>& g) {
  return Gradient<F>(constant_as(c, g.value));
}

/// All values of an interval: itself.
template <Real R> ISO_HD inline const Interval<R>& interval_of(const Interval<R>& f) { return f; }

/// Whether an inclusion says where in its part f may be a value.
template <class F> inline constexpr bool kTrims = false;
template <Real R> inline constexpr bool kTrims<AffineForm<R, 1>> = true;

/// What an inclusion says of f at the near end of its part.
template <Real R> ISO_HD inline const Interval<R>& near_end_of(const Interval<R>& f) { return f; }
template <Real R> ISO_HD inline Interval<R> near_end_of(const AffineForm<R, 1>& f) {
  const R middle = f.c - f.e[0], radius = with_roundings(raised(f.r), abs(middle));
  return Interval<R>(down_exact_zero(middle - radius), up_exact_zero(middle + radius), f.defined,
                     f.continuous, f.empty);
}

/// One coordinate of a ray over a part [s0, s1] of it: e + s d +- slack.
template <Real R> struct RayPart {
  R s0, s1, middle, half;
  ISO_HD RayPart(R from, R to) : s0(from), s1(to), middle(R(0.5) * (from + to)), half(R(0.5) * (to - from)) {}

  ISO_HD void coordinate(R e, R d, R, int, R& x) const { x = e + middle * d; }
  ISO_HD void coordinate(R e, R d, R slack, int, Interval<R>& x) const {
    const R a = e + s0 * d, b = e + s1 * d;
    x = Interval<R>(min(a, b) - slack, max(a, b) + slack);
  }
  /// Follows the ray's symbol: -1 at s0, 1 at s1.
  ISO_HD void coordinate(R e, R d, R slack, int, AffineForm<R, 1>& x) const {
    const Mask<R> yes = Mask<R>(true);
    x.c = e + middle * d;
    x.e[0] = half * d;
    x.r = slack;
    x.defined = x.continuous = yes;
    x.empty = !yes;
  }
  template <class F> ISO_HD void coordinate(R e, R d, R slack, int axis, Gradient<F>& x) const {
    F value;
    coordinate(e, d, slack, axis, value);
    using S = Scalar<R>;
    x = Gradient<F>(value, F(S(axis == 0)), F(S(axis == 1)), F(S(axis == 2)));
  }

  /// The n-th of the inputs of evaluate_some<kStride>: e(a), d(a) and slack(a) are those of axis a.
  template <int kStride, class Kind, class E, class D, class W>
  ISO_HD void put(Kind* inputs, int n, double time, E e, D d, W slack) const {
    for (int a = 0; a < 3; ++a) coordinate(e(a), d(a), slack(a), a, inputs[a * kStride + n]);
    inputs[3 * kStride + n] = constant_as({time, true}, Kind{});
  }
};

}  // namespace isocast::inline ISO_ISA
