// What a formula's tape may be run on to enclose it, and how a segment of a ray becomes its argument.
#pragma once

#include <isocast/implicit/expression/evaluate.h>
#include <isocast/math/affine_functions.h>
#include <isocast/math/gradient_functions.h>
#include <isocast/math/interval_functions.h>

namespace isocast::inline ISO_ISA {

template <Real R> ISO_HD inline Interval<R> constant_as(TapeConstant c, const Interval<R>&) {
  return enclosed<R>(c.value, c.exact);
}
template <Real R, int N> ISO_HD inline AffineForm<R, N> constant_as(TapeConstant c, const AffineForm<R, N>&) {
  return AffineForm<R, N>(enclosed<R>(c.value, c.exact));
}
template <class F> ISO_HD inline Gradient<F> constant_as(TapeConstant c, const Gradient<F>& g) {
  return Gradient<F>(constant_as(c, g.value));
}

/// One coordinate from its inclusions at the two ends of a segment.
template <Real R>
ISO_HD inline Interval<R> coordinate_between(const Interval<R>& a, const Interval<R>& b, const Interval<R>&) {
  return Interval<R>(min(a.lo, b.lo), max(a.hi, b.hi));
}
/// The same as a form that follows the ray's symbol: -1 at a, 1 at b.
template <Real R>
ISO_HD inline AffineForm<R, 1> coordinate_between(const Interval<R>& a, const Interval<R>& b,
                                                  const AffineForm<R, 1>&) {
  const AffineForm<R, 1> p(a), q(b);
  AffineForm<R, 1> x = p;
  x.c = R(0.5) * p.c + R(0.5) * q.c;
  x.e[0] = R(0.5) * q.c - R(0.5) * p.c;
  x.r = max(p.r, q.r) + R(Scalar<R>(4) * kSpacing<Scalar<R>>) * (abs(p.c) + abs(q.c)) + underflow<R>();
  return settled(x);
}

/// All values of an interval: itself.
template <Real R> ISO_HD inline const Interval<R>& interval_of(const Interval<R>& f) { return f; }

}  // namespace isocast::inline ISO_ISA
