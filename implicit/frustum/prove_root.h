// What signs prove of a polynomial whose coefficients are known up to a margin.
#pragma once

#include <isocast/implicit/frustum/bezier.h>

namespace isocast::inline ISO_ISA {

/// What the coefficients of parts can be off by: `margin`, and with every division `step` more.
template <Real R> struct Doubt {
  R margin, step;
  void divide() { margin = margin + step; }
};

/// No root in [0, 1]: a chain of parts whose coefficients all keep their sign by more than the margin.
template <Real R> inline Mask<R> is_empty(Bezier<R> rest, Doubt<R> doubt, Mask<R> active) {
  constexpr int kMostParts = 24;
  Mask<R> empty = active & rest.keeps_sign(doubt.margin);
  active = active & !empty;
  R share = R(0.5);
  for (int i = 0; i < kMostParts && any(active); ++i) {
    Bezier<R> left, right;
    rest.divide(share, left, right);
    doubt.divide();
    const Mask<R> clear = active & left.keeps_sign(doubt.margin);
    assign(rest, clear, right);
    const Mask<R> done = clear & right.keeps_sign(doubt.margin);
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

/// s     a root that a finder reported within eps
/// sure  what FirstRoot says
template <Real R>
inline ProvedRoot<R> prove_root(const Bezier<R>& p, const BezierValues<R>& values, R s, R eps, Doubt<R> doubt,
                                Mask<R> active, Mask<R> sure = Mask<R>(false)) {
  using T = Scalar<R>;
  const R margin = doubt.margin;
  const R rounding = R(T(8) * kUnitRoundoff<T>);
  ProvedRoot<R> root{s, s, s, Mask<R>(false)};
  const R low = max(s - eps, R(0)), high = min(s + eps, R(1));
  constexpr T kClose = sizeof(T) == 4 ? T(0x1p-12) : T(0x1p-26);  // a step's error is about its square
  R slope = R(0);
  Mask<R> far = active;
  for (int i = 0; i < 2 && any(far); ++i) {
    R value, here;
    values.find(root.s, value, here);
    slope = select(far, here, slope);
    const R next = root.s - value / here, there = min(max(next, low), high);
    const Mask<R> moves = far & (next == next);
    far = moves & (abs(there - root.s) > R(kClose));
    root.s = select(moves, there, root.s);
  }
  // far enough for the signs to be sure
  const R clearance = R(T(2)) * (margin + abs(values.at(root.s))) / abs(slope) + rounding;
  Mask<R> starts = Mask<R>(false);  // on the side of 0
  R reach = select(clearance == clearance, min(clearance, eps + rounding), eps + rounding);
  for (int i = 0; i < 2; ++i) {
    const Mask<R> open = active & !root.proved;
    if (!any(open)) break;
    root.lo = select(open, max(root.s - reach, R(0)), root.lo);
    root.hi = select(open, min(root.s + reach, R(1)), root.hi);
    const R before = values.at(root.lo), behind = values.at(root.hi);
    const Mask<R> differs =
        open & (abs(before) > margin) & (abs(behind) > margin) & (negative(before) != negative(behind));
    starts = starts | (differs & (negative(before) == negative(p.c[0])));
    root.proved = root.proved | differs;
    reach = max(R(T(8)) * reach, eps);
  }
  const Mask<R> known = root.proved & sure & starts, asked = root.proved & !known;
  if (any(asked)) {
    Bezier<R> before = p;
    before.keep_left(root.lo);
    doubt.divide();
    root.proved = known | is_empty(before, doubt, asked);
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
