// Bracketed root refinement: the iterations that every intersector shares.
#pragma once

#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

/// f(lo) and f(hi) differ in sign (zero counts as positive), so a root lies between.
template <Real R> struct Bracket { R lo, hi, flo, fhi; };

/// Replaces the end whose sign f(s) has, in the lanes of `active`.
template <Real R> ISO_HD inline void narrow(Bracket<R>& b, R s, R fs, Mask<R> active) {
  const Mask<R> left = active & (negative(fs) == negative(b.flo));
  const Mask<R> right = active & !left;
  b.lo = select(left, s, b.lo);
  b.flo = select(left, fs, b.flo);
  b.hi = select(right, s, b.hi);
  b.fhi = select(right, fs, b.fhi);
}

/// Zero of the chord, kept inside the bracket (also when both ends underflowed to zero).
template <Real R> ISO_HD inline R chord_zero(const Bracket<R>& b) {
  const R s = b.lo + (b.hi - b.lo) * (b.flo / (b.flo - b.fhi));
  return max(min(s, b.hi), b.lo);
}

/// n steps of regula falsi, then the zero of the last chord. One end may never move: no error bound but the
/// bracket.
template <Real R, class F> ISO_HD inline R regula_falsi(F f, Bracket<R>& b, int n) {
  for (int i = 0; i < n; ++i) {
    const R s = chord_zero(b);
    narrow(b, s, f(s), Mask<R>(true));
  }
  return chord_zero(b);
}

/// n halvings: the middle is off by at most 2^-(n+1) of the bracket.
template <Real R, class F> ISO_HD inline R bisect(F f, Bracket<R>& b, int n) {
  for (int i = 0; i < n; ++i) {
    const R s = R(0.5) * (b.lo + b.hi);
    narrow(b, s, f(s), Mask<R>(true));
  }
  return R(0.5) * (b.lo + b.hi);
}

/// Regula falsi until a step is below `tolerance`, at most 64 steps.
template <Real R, class F>
ISO_HD inline R regula_falsi_adaptive(F f, Bracket<R>& b, R tolerance, Mask<R> active) {
  R s = chord_zero(b);
  for (int i = 0; i < 64 && any(active); ++i) {
    narrow(b, s, f(s), active);
    const R next = chord_zero(b);
    active = active & (abs(next - s) > tolerance);
    s = next;
  }
  return s;
}

/// Newton's steps from the chord's zero, halving the bracket instead whenever a step leaves it or is more
/// than half of the step before. Once a Newton step is small (it squares the error) the signs at s -
/// tolerance and s + tolerance are asked: where they differ the bracket is theirs; elsewhere (near multiple
/// roots) the steps go on until they fall below the tolerance, twice at most. Lanes outside `active` are left
/// alone, and no lane depends on another: the same bits for every width. Needs f' in df.
template <Real R, class F, class D>
ISO_HD inline R newton_bracketed(F f, D df, Bracket<R>& b, R tolerance, Mask<R> active) {
  const R enclosed = R(3) * tolerance;
  R s = chord_zero(b), small = sqrt(tolerance);
  for (int round = 0; round < 3 && any(active); ++round) {
    R last = b.hi - b.lo;
    Mask<R> moving = active;
    while (any(moving)) {
      const R fs = f(s);
      narrow(b, s, fs, moving);
      const R newton = s - fs / df(s);
      const Mask<R> good = (newton >= b.lo) & (newton <= b.hi) & (abs(newton - s) <= R(0.5) * abs(last));
      const R next = select(good, newton, R(0.5) * (b.lo + b.hi));
      last = select(moving, next - s, last);
      s = select(moving, next, s);
      moving = moving & (abs(last) > select(good, small, tolerance));
    }
    const R below = max(b.lo, s - tolerance), above = min(b.hi, s + tolerance);
    narrow(b, below, f(below), active);
    narrow(b, above, f(above), active & (above > b.lo) & (above < b.hi));
    active = active & (b.hi - b.lo > enclosed);
    s = max(min(s, b.hi), b.lo);
    small = tolerance;
  }
  return s;
}

}  // namespace isocast::inline ISO_ISA
