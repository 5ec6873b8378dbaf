// Intervals over any Real: what they are, and + - * / with outward rounding.
#pragma once

#include <isocast/math/rounding.h>

namespace isocast::inline ISO_ISA {

/// An inclusion: every value that f takes where it is defined, over the box in question, lies in [lo, hi].
///
/// lo, hi      never NaN; lo is never +inf and hi never -inf, so overflow keeps containing the value
/// defined     f has a value everywhere in the box
/// continuous  so it has, and f restricted to the box is continuous
/// empty       f has a value nowhere in the box; the bounds then mean nothing
/// Each lane has its own. An operation can only take `defined` and `continuous` away and only add `empty`.
/// source  Knoll et al.: Fast ray tracing of arbitrary implicit surfaces with interval and affine arithmetic,
///         Computer Graphics Forum 28(1), 2009; the decorations are in the manner of IEEE 1788
template <Real R> struct Interval {
  R lo, hi;
  Mask<R> defined, continuous, empty;

  Interval() = default;
  ISO_HD Interval(R low, R high, Mask<R> is_defined, Mask<R> is_continuous, Mask<R> is_empty)
      : lo(low), hi(high), defined(is_defined), continuous(is_continuous), empty(is_empty) {}
  /// The argument itself, from `low` to `high`. A NaN, or low > high, gives all numbers, undefined.
  ISO_HD Interval(R low, R high) : empty(Mask<R>(false)) {
    using T = Scalar<R>;
    const Mask<R> ordered = low <= high;
    lo = select(ordered, min(low, R(kLargest<T>)), R(-kInfinity<T>));
    hi = select(ordered, max(high, R(-kLargest<T>)), R(kInfinity<T>));
    defined = continuous = ordered;
  }
  ISO_HD explicit Interval(R x) : Interval(x, x) {}
  ISO_HD explicit Interval(Scalar<R> x) requires(kWidth<R> > 1) : Interval(R(x)) {}
};

/// [lo, hi] with the decorations of a: the result of a function that is continuous everywhere.
template <Real R> ISO_HD inline Interval<R> decorated_as(const Interval<R>& a, R lo, R hi) {
  return Interval<R>(lo, hi, a.defined, a.continuous, a.empty);
}
/// The same of two operands.
template <Real R>
ISO_HD inline Interval<R> decorated_as(const Interval<R>& a, const Interval<R>& b, R lo, R hi) {
  return Interval<R>(lo, hi, a.defined & b.defined, a.continuous & b.continuous, a.empty | b.empty);
}
/// a, which is defined and continuous only under `smooth`; nowhere defined under `nowhere`.
template <Real R> ISO_HD inline Interval<R> limited(Interval<R> a, Mask<R> smooth, Mask<R> nowhere) {
  a.defined = a.defined & smooth;
  a.continuous = a.continuous & smooth;
  a.empty = a.empty | nowhere;
  return a;
}
/// a, which is continuous only under `smooth`.
template <Real R> ISO_HD inline Interval<R> continuous_where(Interval<R> a, Mask<R> smooth) {
  a.continuous = a.continuous & smooth;
  return a;
}

/// An interval that holds the number whose nearest double is `nearest`; `exact` when it is that double.
/// At most three numbers wide, one where nothing was rounded.
template <Real R> ISO_HD inline Interval<R> enclosed(double nearest, bool exact) {
  using T = Scalar<R>;
  const T x = static_cast<T>(nearest);
  const double rounded = static_cast<double>(x);
  const bool same = exact && rounded == nearest, below = rounded<nearest, above = rounded> nearest;
  return {R(same || below ? x : down(x)), R(same || above ? x : up(x))};
}

/// a's ends cut to [lo, hi].
template <Real R> ISO_HD inline Interval<R> cut(const Interval<R>& a, R lo, R hi) {
  return decorated_as(a, max(min(a.lo, hi), lo), min(max(a.hi, lo), hi));
}

/// f is not zero anywhere in the box: the only reason to reject it. A NaN that came in never proves it.
template <Real R> ISO_HD inline Mask<R> excludes_zero(const Interval<R>& a) {
  return (a.lo > R(0)) | (a.hi < R(0)) | a.empty;
}
template <Real R> ISO_HD inline Mask<R> holds_zero(const Interval<R>& a) {
  return (a.lo <= R(0)) & (a.hi >= R(0));
}
/// f >= 0, or f <= 0, in all of the box.
template <Real R> ISO_HD inline Mask<R> not_negative(const Interval<R>& a) { return a.lo >= R(0); }
template <Real R> ISO_HD inline Mask<R> not_positive(const Interval<R>& a) { return a.hi <= R(0); }

/// Lane by lane a where m holds, else b.
template <Real R> ISO_HD inline Interval<R> select(Mask<R> m, const Interval<R>& a, const Interval<R>& b) {
  return Interval<R>(select(m, a.lo, b.lo), select(m, a.hi, b.hi), select(m, a.defined, b.defined),
                     select(m, a.continuous, b.continuous), select(m, a.empty, b.empty));
}

/// Holds both, for a choice that is not decided within the box: a jump from one to the other is possible.
template <Real R> ISO_HD inline Interval<R> united(const Interval<R>& a, const Interval<R>& b) {
  const R lo = select(a.empty, b.lo, select(b.empty, a.lo, min(a.lo, b.lo)));
  const R hi = select(a.empty, b.hi, select(b.empty, a.hi, max(a.hi, b.hi)));
  return Interval<R>(lo, hi, a.defined & b.defined, Mask<R>(false), a.empty & b.empty);
}

/// Two inclusions of one f over one box: what either proves holds.
template <Real R> ISO_HD inline Interval<R> intersected(const Interval<R>& a, const Interval<R>& b) {
  return Interval<R>(max(a.lo, b.lo), min(a.hi, b.hi), a.defined | b.defined, a.continuous | b.continuous,
                     a.empty | b.empty);
}

template <Real R> ISO_HD inline Interval<R> operator-(const Interval<R>& a) {
  return decorated_as(a, -a.hi, -a.lo);
}
template <Real R> ISO_HD inline Interval<R> operator+(const Interval<R>& a, const Interval<R>& b) {
  return decorated_as(a, b, down_exact_zero(a.lo + b.lo), up_exact_zero(a.hi + b.hi));
}
template <Real R> ISO_HD inline Interval<R> operator-(const Interval<R>& a, const Interval<R>& b) {
  return a + (-b);
}

/// The hull of four products or quotients of ends, rounded outward; sides that the signs decide stay at zero.
/// NaN comes from 0 * inf, 0 / 0 and inf / inf only, where zero is right or another end covers it.
template <Real R>
ISO_HD inline Interval<R> hull_of_four(const Interval<R>& a, const Interval<R>& b, R p, R q, R r, R s) {
  const auto number = [](R x) { return select(x == x, x, R(0)); };
  p = number(p), q = number(q), r = number(r), s = number(s);
  const R lo = down(min(min(p, q), min(r, s))), hi = up(max(max(p, q), max(r, s)));
  const Mask<R> same = (not_negative(a) & not_negative(b)) | (not_positive(a) & not_positive(b));
  const Mask<R> opposite = (not_negative(a) & not_positive(b)) | (not_positive(a) & not_negative(b));
  return decorated_as(a, b, select(same, max(lo, R(0)), lo), select(opposite, min(hi, R(0)), hi));
}

/// The hull of the products of ends, 0 * inf counting as 0.
template <Real R> ISO_HD inline Interval<R> operator*(const Interval<R>& a, const Interval<R>& b) {
  return hull_of_four(a, b, a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi);
}

/// The hull of the quotients of ends. A divisor with zero at one end gives a half line where the dividend has
/// one sign, one with zero inside, or only zero, all numbers; either is undefined, the last one empty.
template <Real R> ISO_HD inline Interval<R> operator/(const Interval<R>& a, const Interval<R>& b) {
  // a zero at an end has the sign of the other end, and so has the quotient's infinity
  const R lo = b.lo + R(0), hi = -(-b.hi + R(0));
  const Interval<R> q = hull_of_four(a, b, a.lo / lo, a.lo / hi, a.hi / lo, a.hi / hi);
  const Mask<R> only_zero = (b.lo == R(0)) & (b.hi == R(0));
  const Mask<R> inside = ((b.lo < R(0)) & (b.hi > R(0))) | only_zero;
  const R all = R(kInfinity<Scalar<R>>);
  return limited(decorated_as(q, select(inside, -all, q.lo), select(inside, all, q.hi)), !holds_zero(b),
                 only_zero);
}

template <Real R> ISO_HD inline Interval<R> abs(const Interval<R>& a) {
  return decorated_as(a, max(max(a.lo, -a.hi), R(0)), max(-a.lo, a.hi));
}
template <Real R> ISO_HD inline Interval<R> min(const Interval<R>& a, const Interval<R>& b) {
  return decorated_as(a, b, min(a.lo, b.lo), min(a.hi, b.hi));
}
template <Real R> ISO_HD inline Interval<R> max(const Interval<R>& a, const Interval<R>& b) {
  return decorated_as(a, b, max(a.lo, b.lo), max(a.hi, b.hi));
}

}  // namespace isocast::inline ISO_ISA
