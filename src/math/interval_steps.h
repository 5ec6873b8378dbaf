// Intervals: functions with jumps, and the choice that a condition makes.
#pragma once

#include <isocast/math/functions.h>
#include <isocast/math/interval.h>

namespace isocast::inline ISO_ISA {

/// A function that only rises, in steps, with values lo and hi at the ends of a: continuous on one step.
template <Real R> ISO_HD inline Interval<R> steps(const Interval<R>& a, R lo, R hi) {
  return continuous_where(decorated_as(a, lo, hi), lo == hi);
}

template <Real R> ISO_HD inline Interval<R> floor(const Interval<R>& a) {
  return steps(a, floor(a.lo), floor(a.hi));
}
template <Real R> ISO_HD inline Interval<R> ceil(const Interval<R>& a) {
  return steps(a, ceil(a.lo), ceil(a.hi));
}
template <Real R> ISO_HD inline Interval<R> round(const Interval<R>& a) {
  return steps(a, round(a.lo), round(a.hi));
}
template <Real R> ISO_HD inline Interval<R> sign(const Interval<R>& a) {
  return steps(a, sign(a.lo), sign(a.hi));
}

/// a - b floor(a / b), which lies between 0 and b; undefined where b may be zero.
template <Real R> ISO_HD inline Interval<R> mod(const Interval<R>& a, const Interval<R>& b) {
  return cut(a - b * floor(a / b), min(b.lo, R(0)), max(b.hi, R(0)));
}

/// 0 for a < edge, 1 for a >= edge, both and not continuous where that is not decided.
template <Real R> ISO_HD inline Interval<R> step(const Interval<R>& edge, const Interval<R>& a) {
  const Mask<R> always = a.lo >= edge.hi, never = a.hi < edge.lo;
  return continuous_where(decorated_as(edge, a, select(always, R(1), R(0)), select(never, R(0), R(1))),
                          always | never);
}

/// a where the condition is not zero, b where it is, both where that is not decided. The branch that is not
/// taken need not be defined.
template <Real R>
ISO_HD inline Interval<R> choose(const Interval<R>& condition, const Interval<R>& a, const Interval<R>& b) {
  const Mask<R> always = (condition.lo > R(0)) | (condition.hi < R(0));
  const Mask<R> never = (condition.lo == R(0)) & (condition.hi == R(0));
  const Interval<R> chosen = select(always, a, select(never, b, united(a, b)));
  return decorated_as(condition, chosen, chosen.lo, chosen.hi);
}

}  // namespace isocast::inline ISO_ISA
