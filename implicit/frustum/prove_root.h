// What signs prove of a polynomial whose coefficients are known up to a margin.
#pragma once

#include <isocast/implicit/frustum/bezier.h>

namespace isocast::inline ISO_ISA {

/// No root in [0, 1]: a chain of parts whose coefficients all keep their sign by more than the margin.
template <Real R> inline Mask<R> is_empty(Bezier<R> rest, R margin, Mask<R> active) {
  constexpr int kMostParts = 24;
  Mask<R> empty = active & rest.keeps_sign(margin);
  active = active & !empty;
  R share = R(0.5);
  for (int i = 0; i < kMostParts && any(active); ++i) {
    Bezier<R> left, right;
    rest.divide(share, left, right);
    const Mask<R> clear = active & left.keeps_sign(margin);
    assign(rest, clear, right);
    const Mask<R> done = clear & right.keeps_sign(margin);
    empty = empty | done;
    share = select(clear, R(0.5), R(0.5) * share);
    active = active & !done & (share > R(Scalar<R>(0.01)));
  }
  return empty;
}

/// A root brought closer by Newton's steps, and the bracket around it whose ends' signs prove it, with
/// nothing before it.
template <Real R> struct ProvedRoot {
  R s, lo, hi;
  Mask<R> proved;

  void replace(Mask<R> lanes, const ProvedRoot& other) {
    s = select(lanes, other.s, s), lo = select(lanes, other.lo, lo), hi = select(lanes, other.hi, hi);
    proved = select(lanes, other.proved, proved);
  }
};

/// s  a root that a finder reported within eps
template <Real R> inline ProvedRoot<R> prove_root(const Bezier<R>& p, R s, R eps, R margin, Mask<R> active) {
  using T = Scalar<R>;
  const R rounding = R(T(8) * kUnitRoundoff<T>);
  ProvedRoot<R> root{s, s, s, Mask<R>(false)};
  const R low = max(s - eps, R(0)), high = min(s + eps, R(1));
  R slope = R(0), value = R(0);
  for (int i = 0; i < 2; ++i) {
    value = p.at(root.s);
    slope = p.slope_at(root.s);
    const R next = root.s - value / slope;
    root.s = select(active & (next == next), min(max(next, low), high), root.s);
  }
  // far enough for the signs to be sure
  const R clearance = R(T(2)) * (margin + abs(p.at(root.s))) / abs(slope) + rounding;
  R reach = select(clearance == clearance, min(clearance, eps + rounding), eps + rounding);
  for (int i = 0; i < 2; ++i) {
    const Mask<R> open = active & !root.proved;
    if (!any(open)) break;
    root.lo = select(open, max(root.s - reach, R(0)), root.lo);
    root.hi = select(open, min(root.s + reach, R(1)), root.hi);
    const R before = p.at(root.lo), behind = p.at(root.hi);
    root.proved = root.proved | (open & (abs(before) > margin) & (abs(behind) > margin) &
                                 (negative(before) != negative(behind)));
    reach = max(R(T(8)) * reach, eps);
  }
  if (any(root.proved)) {
    Bezier<R> before = p;
    before.keep_left(root.lo);
    root.proved = is_empty(before, margin, root.proved);
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
