// The first root by subdivision: at the zero of the control polygon (LR), or in the middle (Schneider).
#pragma once

#include <isocast/implicit/frustum/finder.h>

namespace isocast::inline ISO_ISA {

/// A polynomial's piece over [from, to].
template <Real R> struct BezierPiece {
  Bezier<R> p;
  R from, to;
};

/// Pieces that wait, each lane's nearest on top.
template <Real R> class WaitingPieces {
 public:
  static constexpr int kMost = 16;
  /// Lanes that have no room left are returned.
  Mask<R> push(Mask<R> lanes, const Bezier<R>& p, R from, R to) {
    using T = Scalar<R>;
    for (int i = 0; i < kMost; ++i) {
      const Mask<R> here = lanes & (count_ == R(T(i)));
      if (!any(here)) continue;
      pieces_[i].p.degree = p.degree;
      for (int k = 0; k <= p.degree; ++k) pieces_[i].p.c[k] = select(here, p.c[k], pieces_[i].p.c[k]);
      pieces_[i].from = select(here, from, pieces_[i].from);
      pieces_[i].to = select(here, to, pieces_[i].to);
    }
    const Mask<R> full = lanes & (count_ == R(T(kMost)));
    count_ = count_ + select(lanes & !full, R(1), R(0));
    return full;
  }
  Mask<R> empty() const { return count_ == R(0); }
  void pop(Mask<R> lanes, BezierPiece<R>& piece) {
    using T = Scalar<R>;
    count_ = count_ - select(lanes, R(1), R(0));
    for (int i = 0; i < kMost; ++i) {
      const Mask<R> here = lanes & (count_ == R(T(i)));
      if (!any(here)) continue;
      assign(piece.p, here, pieces_[i].p);
      piece.from = select(here, pieces_[i].from, piece.from);
      piece.to = select(here, pieces_[i].to, piece.to);
    }
  }

 private:
  R count_ = R(0);
  BezierPiece<R> pieces_[kMost];
};

/// Where a polygon's zero is bounded by knots that are d-fold at both ends of the piece: the density h of the
/// source, with f(x) = O(h^2).
template <Real R> inline R density(const BezierPiece<R>& piece, const PolygonZero<R>& zero, R x) {
  const R degree = R(Scalar<R>(piece.p.degree));
  return max(select(zero.k < degree, abs(x - piece.from), R(0)),
             select(zero.k > R(1), abs(x - piece.to), R(0)));
}

/// The LR-Mult rule: when the zero of the control polygon lies beside the last subdivision, the step from
/// there is lengthened by the root's multiplicity, if it stays inside the piece. last_is_end: the piece ends
/// with that subdivision, else it begins with it.
template <Real R>
inline R lengthened(const BezierPiece<R>& piece, const PolygonZero<R>& zero, R x, Mask<R> last_is_end) {
  const Bezier<R>& p = piece.p;
  const int d = p.degree;
  if (d < 2) return x;
  const R degree = R(Scalar<R>(d));
  const Mask<R> beside = select(last_is_end, zero.k == degree, zero.k == R(1));
  const R f0 = select(last_is_end, p.c[d], p.c[0]), f1 = select(last_is_end, p.c[d - 1], p.c[1]),
          f2 = select(last_is_end, p.c[d - 2], p.c[2]);
  // in units of the piece; the signs of both slopes cancel
  const R slope = degree * (f1 - f0), bend = degree * (degree - R(1)) * ((f2 - f1) - (f1 - f0));
  const R last = select(last_is_end, piece.to, piece.from);
  const R longer = last + step_factor(f0, slope, bend, degree) * (x - last);
  return select(beside & (longer > piece.from) & (longer < piece.to), longer, x);
}

/// The largest distance of the control points from the chord, as a share of the chord's rise: where a single
/// crossing can be.
template <Real R> inline R flatness(const Bezier<R>& p) {
  const int d = p.degree;
  R off = R(0);
  for (int k = 1; k < d; ++k)
    off = max(off, abs(p.c[k] - lerp(p.c[0], p.c[d], R(Scalar<R>(k) / Scalar<R>(d)))));
  return off / abs(p.c[d] - p.c[0]);
}

/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008, for LR and LR-Mult; Schneider: A Bezier curve-based root-finder, Graphics Gems, 1990
template <RootFinder kFinder, Real R>
inline FirstRoot<R> find_by_parts(const Bezier<R>& whole, const FinderOptions& options, R eps,
                                  Mask<R> active) {
  constexpr bool kHalves = kFinder == RootFinder::schneider;
  const R small_value = eps * eps * whole.largest();
  FirstRoot<R> root;
  BezierPiece<R> piece{whole, R(0), R(1)};
  WaitingPieces<R> waiting;
  Mask<R> last_is_end = Mask<R>(false), divided = Mask<R>(false);
  for (int step = 0; any(active);) {
    const PolygonZero<R> zero = polygon_zero(piece.p);
    const Mask<R> nothing = active & !zero.found;
    if (any(nothing)) {
      active = active & !(nothing & waiting.empty());
      const Mask<R> next = nothing & active;
      if (any(next)) waiting.pop(next, piece);
      last_is_end = last_is_end & !next;
      continue;
    }
    if (step == options.most) {
      root.give_up(active, piece.from + (piece.to - piece.from) * zero.s);
      break;
    }
    const R length = piece.to - piece.from;
    R x = piece.from + length * zero.s;
    Mask<R> stops;
    if constexpr (kHalves)
      stops = (length < eps) | ((zero.changes == R(1)) & (flatness(piece.p) * length < eps));
    else if (options.value) stops = length < eps;
    else stops = density(piece, zero, x) < eps;
    if (piece.p.degree == 1) stops = Mask<R>(true);
    root.settle(active & stops, x);
    active = active & !stops;
    if (!any(active)) break;

    R share = R(0.5);
    if constexpr (!kHalves) share = zero.s;
    if constexpr (kFinder == RootFinder::lr_mult) {
      x = select(divided, lengthened(piece, zero, x, last_is_end), x);
      share = clamp01((x - piece.from) / length);
    }
    if constexpr (kHalves) x = piece.from + R(0.5) * length;
    Bezier<R> left, right;
    piece.p.divide(share, left, right);
    root.steps = root.steps + select(active, R(1), R(0));
    ++step;
    if (!kHalves && options.value) {
      const Mask<R> there = active & (abs(right.c[0]) < small_value);
      root.settle(there, x);
      active = active & !there;
    }
    const Mask<R> first = left.changes_sign();
    // where the polygon crosses once, only one part has a crossing
    const Mask<R> both = active & first & (zero.changes > R(1));
    if (any(both)) root.open = root.open | waiting.push(both, right, x, piece.to);
    assign(piece.p, active & first, left);
    assign(piece.p, active & !first, right);
    piece.to = select(active & first, x, piece.to);
    piece.from = select(active & !first, x, piece.from);
    last_is_end = select(active, first, last_is_end);
    divided = divided | active;
  }
  return root;
}

}  // namespace isocast::inline ISO_ISA
