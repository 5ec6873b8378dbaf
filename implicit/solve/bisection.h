// The first root along a segment by bisection: parts whose inclusion leaves out every iso-value hold none.
#pragma once

#include <isocast/implicit/solve/lanes.h>

namespace isocast::inline ISO_ISA {

/// Parts of this length, in s, are not divided: below, their ends are hardly apart in the arithmetic.
template <class T> inline constexpr T kLeast = T(0);
template <> inline constexpr float kLeast<float> = 0x1p-21f;
template <> inline constexpr double kLeast<double> = 0x1p-44;

/// Small parts of a segment that are looked at before none is divided any more: bounds the work where f hugs an
/// iso-value or is unbounded all along a ray.
inline constexpr int kMostJudged = 1024;

/// A root, lane by lane, as in SegmentRoots.
template <Real R> struct SegmentRoot {
  R lo, hi, iso;
  Mask<R> hit, crossing, doubt, monotone, below;
};

/// What a part that may hold a root turned out to be.
///
/// accepted  a root is reported: one crossing in a part where f is monotone, or the part cannot be divided
/// empty     f is monotone and has the same side of every iso-value at both ends; or nothing can be said of
///           the part, which touches a start on the surface or where f is unbounded: that is `doubt`
template <Real R> struct PartVerdict {
  Mask<R> accepted, empty, doubt, crossing, monotone, below;
  R iso;
};
template <Real R>
ISO_HD inline PartVerdict<R> judge(SegmentLanes<R>& lanes, const Interval<R>& f, R lo, R hi, Mask<R> last) {
  using T = Scalar<R>;
  const Interval<R> fa = lanes.at(lo), fb = lanes.at(hi);
  PartVerdict<R> v;
  v.crossing = v.below = Mask<R>(false);
  v.iso = R(0);
  Mask<R> several = v.crossing, same = Mask<R>(true);
  for (int i = lanes.iso_count() - 1; i >= 0; --i) {
    const Sides<R> a = lanes.sides_at(lo, fa, i), b = lanes.sides_at(hi, fb, i);
    const Mask<R> crosses = ((a.below & b.above) | (a.above & b.below)) & f.continuous;
    several = several | (v.crossing & crosses);
    v.crossing = v.crossing | crosses;
    v.iso = select(crosses, R(T(i)), v.iso);
    v.below = select(crosses, a.below, v.below);
    same = same & ((a.below & b.below) | (a.above & b.above));
    // without any crossing, the iso-value that f holds
    const Sides<R> whole = lanes.sides(f, i);
    v.iso = select(v.crossing | whole.below | whole.above, v.iso, R(T(i)));
  }
  const Interval<R> slope = lanes.slope(lo, hi);
  v.monotone = slope.defined & f.continuous & ((slope.lo > R(0)) | (slope.hi < R(0)));
  v.empty = v.monotone & same;
  const Mask<R> finite = (f.lo > R(-kLargest<T>)) & (f.hi < R(kLargest<T>));
  v.doubt = last & (!(v.crossing | v.empty)) & (lanes.at_known_start(lo) | (!finite));
  v.empty = v.empty | v.doubt;
  v.accepted = (!v.empty) & ((v.crossing & v.monotone & (!several)) | last);
  return v;
}

/// Brings the bracket of crossings where f is monotone to the end of the arithmetic, as far as the signs of f
/// can be proved.
template <Real R> ISO_HD inline void refine(SegmentLanes<R>& lanes, SegmentRoot<R>& root, Mask<R> active) {
  using T = Scalar<R>;
  while (any(active)) {
    const R middle = R(0.5) * root.lo + R(0.5) * root.hi;
    active = active & (middle > root.lo) & (middle < root.hi) & (root.hi - root.lo > R(kLeast<T>));
    if (!any(active)) break;
    lanes.count(active, 1);
    const Interval<R> f = lanes.at(middle);
    Mask<R> near = Mask<R>(false), far = near;
    for (int i = 0; i < lanes.iso_count(); ++i) {
      const Sides<R> side = lanes.sides(f, i);
      const Mask<R> mine = root.iso == R(T(i));
      near = near | (mine & select(root.below, side.below, side.above));
      far = far | (mine & select(root.below, side.above, side.below));
    }
    root.lo = select(active & near, middle, root.lo);
    root.hi = select(active & far, middle, root.hi);
    active = active & (near | far);
  }
}

/// The part of [lo, hi] where c + e E +- r may be an iso-value: what is left of E in [-1, 1].
template <Real R>
ISO_HD inline void trim(const SegmentLanes<R>& lanes, const AffineForm<R, 1>& f, R& lo, R& hi) {
  using T = Scalar<R>;
  R first = R(1), last = R(-1);
  for (int i = 0; i < lanes.iso_count(); ++i) {
    const Interval<R> level = lanes.iso(i) - Interval<R>(f.c - f.r, f.c + f.r);
    const Interval<R> e = level / Interval<R>(f.e[0]);
    first = min(first, e.lo);
    last = max(last, e.hi);
  }
  // roundings of r and of the steps below, for s <= 1; an unknown form keeps everything
  const R slack = R(Scalar<R>(16) * kSpacing<T>);
  const Mask<R> known = (f.r <= R(kLargest<T>)) & (f.e[0] != R(0));
  first = select(known, max(first - slack * (abs(first) + R(1)), R(-1)), R(-1));
  last = select(known, min(last + slack * (abs(last) + R(1)), R(1)), R(1));
  const R half = R(0.5) * (hi - lo), middle = lo + half, near = middle + first * half,
          far = middle + last * half;
  lo = max(lo, near - R(Scalar<R>(4) * kSpacing<T>));
  hi = min(hi, far + R(Scalar<R>(4) * kSpacing<T>));
}
template <Real R> ISO_HD inline void trim(const SegmentLanes<R>&, const Interval<R>&, R&, R&) {}

/// The first root of the lanes in `active`.
///
/// F       Interval<R> or AffineForm<R, 1>
/// walk    without a stack: a part is [s, s + w], w a power of two and s a multiple of it, near half first
/// proved  a hit, if f is continuous in its part and changes sign; a miss; both unless `doubt`
/// source  Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces
/// with
///         interval and affine arithmetic, Computer Graphics Forum 28(1), 2009; the judgement of small parts
///         after Mitchell: Robust ray intersection with interval arithmetic, Graphics Interface 1990
template <class F, Real R>
ISO_HD inline SegmentRoot<R> first_root(SegmentLanes<R>& lanes, R smallest, Mask<R> active) {
  using T = Scalar<R>;
  SegmentRoot<R> root;
  root.hit = root.crossing = root.doubt = root.monotone = root.below = Mask<R>(false);
  root.lo = root.hi = root.iso = R(0);
  smallest = max(smallest, R(kLeast<T>));
  // [.., begin) is proved empty; so is the rest of the part that ends at `cut_end` from `cut` on
  R s = R(0), w = R(1), begin = lanes.begin, cut = R(1), cut_end = R(1), judged = R(0);
  for (Mask<R> busy = active; any(busy);) {
    R lo = max(s, begin), hi = select(s < cut_end, min(s + w, cut), s + w);
    const Mask<R> nothing = lo >= hi;
    hi = max(lo, hi);
    const F f = lanes.template over<F>(lo, hi);
    lanes.count(busy & (!nothing), 1);
    const Interval<R> range = interval_of(f);
    Mask<R> empty = nothing | lanes.leaves_out(range);
    const Mask<R> small = busy & (!empty) & (w <= smallest);
    Mask<R> accepted = Mask<R>(false);
    if (any(small)) {
      lanes.count(small, 3);
      judged = judged + select(small, R(1), R(0));
      const Mask<R> enough = judged > R(T(kMostJudged));
      const PartVerdict<R> v = judge(lanes, range, lo, hi, (w <= R(kLeast<T>)) | enough);
      accepted = small & v.accepted;
      empty = empty | (small & v.empty);
      root.doubt = root.doubt | (small & v.doubt);
      root.hit = root.hit | accepted;
      root.lo = select(accepted, lo, root.lo);
      root.hi = select(accepted, hi, root.hi);
      root.iso = select(accepted, v.iso, root.iso);
      root.crossing = root.crossing | (accepted & v.crossing);
      root.monotone = root.monotone | (accepted & v.monotone & v.crossing);
      root.below = select(accepted, v.below, root.below);
      busy = busy & (!accepted) & (!(small & v.doubt & enough));
    }
    const Mask<R> divide = busy & (!empty), leave = busy & empty;
    if (lanes.trims()) {
      R near = lo, far = hi;
      trim(lanes, f, near, far);
      begin = select(divide, near, begin);
      cut = select(divide, far, cut);
      cut_end = select(divide, s + w, cut_end);
    }
    w = select(divide, R(0.5) * w, w);
    s = select(leave, s + w, s);
    // up while both halves are done
    R number = s / w;
    for (;;) {
      const R half = R(0.5) * number;
      const Mask<R> both = leave & (w < R(1)) & (half == floor(half));
      if (!any(both)) break;
      w = select(both, w + w, w);
      number = select(both, half, number);
    }
    busy = busy & (!(leave & (s >= R(1))));
  }
  refine(lanes, root, root.monotone);
  return root;
}

}  // namespace isocast::inline ISO_ISA
