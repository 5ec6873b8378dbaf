// The first root by Descartes' rule: parts are divided until the nearest with changes of sign has one, whose
// root is Newton's to find.
#pragma once

#include <isocast/implicit/frustum/find_by_parts.h>
#include <isocast/implicit/frustum/prove_root.h>

namespace isocast::inline ISO_ISA {

/// How a polynomial's coefficients change their sign.
///
/// some, more  they do; they do so again
/// zero        of the control polygon: the first, in [0, 1]
/// turn        where, of the coefficients between the first two changes, the largest is
template <Real R> struct SignChanges {
  Mask<R> some = Mask<R>(false), more = Mask<R>(false);
  R zero = R(0), turn = R(0);

  explicit SignChanges(const Bezier<R>& p) {
    using T = Scalar<R>;
    const Mask<R> start = negative(p.c[0]);
    const R step = R(T(1) / T(p.degree)), one = R(1);
    R before = R(0), behind = one, last = R(0), most = R(-1), place = R(0);
    for (int k = 1; k <= p.degree; ++k) {
      const Mask<R> other = negative(p.c[k]) != start, begins = other & !some;
      before = select(begins, p.c[k - 1], before), behind = select(begins, p.c[k], behind);
      last = select(begins, place, last);
      place = place + one;
      some = some | other;
      more = more | (some & !other);
      const R size = abs(p.c[k]);
      const Mask<R> farther = other & (!more) & (size > most);
      most = select(farther, size, most);
      turn = select(farther, place, turn);
    }
    const R share = before / (before - behind);
    zero = (last + select(share == share, share, R(0))) * step;
    turn = turn * step;
  }
};

/// Whether a part whose coefficients change their sign once has one root: the signs are sure but for one
/// beside the change.
template <Real R> inline Mask<R> has_one_root(const Bezier<R>& p, R margin) {
  Mask<R> unsure = Mask<R>(false), more = Mask<R>(false), inside = Mask<R>(false);
  for (int k = 0; k <= p.degree; ++k) {
    const Mask<R> here = abs(p.c[k]) <= margin;
    more = more | (unsure & here);
    unsure = unsure | here;
    if (k > 0 && k < p.degree) inside = inside | (here & (negative(p.c[k - 1]) == negative(p.c[k + 1])));
  }
  return !(more | inside);
}

/// doubt   of the coefficients, for `sure`
/// source  Collins, Akritas: Polynomial real root isolation using Descartes' rule of signs, SYMSAC 1976, in
///         Bernstein form after Lane, Riesenfeld: Bounds on a polynomial, BIT 21, 1981; where parts are
///         divided, and what is proved by the way, is ours
template <Real R>
inline FirstRoot<R> find_by_signs(const Bezier<R>& whole, const BezierValues<R>& values,
                                  const FinderOptions& options, R eps, Doubt<R> doubt, Mask<R> active) {
  using T = Scalar<R>;
  FirstRoot<R> root;
  BezierPiece<R> piece{whole, R(0), R(1)};
  WaitingPieces<R> waiting;
  Mask<R> sure = active, isolated = Mask<R>(false);
  const Mask<R> start = negative(whole.c[0]);
  for (int step = 0; any(active);) {
    const SignChanges<R> changes(piece.p);
    const Mask<R> nothing = active & !changes.some;
    if (any(nothing)) {
      sure = sure & !(nothing & !piece.p.keeps_sign(doubt.margin));
      const Mask<R> last = nothing & waiting.empty();
      root.sure = root.sure | (last & sure);
      active = active & !last;
      const Mask<R> next = nothing & active;
      if (any(next)) waiting.pop(next, piece);
      continue;
    }
    const R length = piece.to - piece.from, x = piece.from + length * changes.zero;
    const Mask<R> single = active & !changes.more;
    if (any(single)) {
      root.sure = root.sure | (single & sure & has_one_root(piece.p, doubt.margin));
      isolated = isolated | single;
    }
    root.settle(single | (active & (length < eps)), x);
    active = active & !root.hit;
    if (!any(active)) break;
    if (step == options.most) {
      root.give_up(active, x);
      break;
    }
    const R share = min(max(changes.turn, R(T(0.125))), R(T(0.875)));
    const R middle = piece.from + length * share;
    Bezier<R> left, right;
    piece.p.divide(share, left, right);
    doubt.divide();
    root.steps = root.steps + select(active, R(1), R(0));
    ++step;
    // a left part whose ends differ has a root, and what is behind it is not asked for
    const Mask<R> crosses = negative(left.c[left.degree]) != start, first = left.changes_sign();
    sure = sure & !(active & (!first) & !left.keeps_sign(doubt.margin));
    const Mask<R> both = active & first & !crosses;
    if (any(both)) {
      const Mask<R> lost = waiting.push(both, right, middle, piece.to);
      root.open = root.open | lost;
      sure = sure & !lost;
    }
    assign(piece.p, active & first, left);
    assign(piece.p, active & !first, right);
    piece.to = select(active & first, middle, piece.to);
    piece.from = select(active & !first, middle, piece.from);
  }
  // Newton's steps, kept between the ends of what has the root
  constexpr int kMostSteps = 8;
  R lo = piece.from, hi = piece.to;
  for (int i = 0; i < kMostSteps && any(isolated); ++i) {
    R value, slope;
    values.find(root.s, value, slope);
    const Mask<R> before = negative(value) == start;
    lo = select(isolated & before, root.s, lo), hi = select(isolated & !before, root.s, hi);
    R next = root.s - value / slope;
    next = select((next >= lo) & (next <= hi), next, R(T(0.5)) * (lo + hi));
    const R step = abs(next - root.s);
    root.s = select(isolated, next, root.s);
    root.steps = root.steps + select(isolated, R(1), R(0));
    isolated = isolated & (step > eps);
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
