// Where in a part of a ray f may be an iso-value, and which of several is met first.
#pragma once

#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/segment.h>

namespace isocast::inline ISO_ISA {

/// Where f lies with regard to an iso-value. Neither: not known.
template <Real R> struct Sides { Mask<R> below, above; };

/// Sides of iso i over what `f` encloses; an undefined f that is not empty has none.
template <Real R>
ISO_HD inline Sides<R> sides_of(const Interval<R>& f, const FormulaQuery<Scalar<R>>& query, int i) {
  return {f.hi<R(query.iso_lo[i]), f.lo> R(query.iso_hi[i])};
}

/// No iso-value lies in f: the only reason to reject a part.
template <Real R>
ISO_HD inline Mask<R> leaves_out(const Interval<R>& f, const FormulaQuery<Scalar<R>>& query) {
  Mask<R> out = Mask<R>(true);
  for (int i = 0; i < query.iso_count; ++i) {
    const Sides<R> s = sides_of(f, query, i);
    out = out & (s.below | s.above);
  }
  return out | f.empty;
}

/// The parts of [0, 1] that may hold a root of some iso-value, put together.
///
/// near, far  all of them; near > far: none was added
/// first_far  the end of the one that begins first: that of `iso`
/// second     where the next begins
/// crosses    in the first one f goes from one side of its iso-value to the other, and is continuous
/// rises      it goes up
template <Real R> struct Levels {
  R near = R(2), far = R(-1), first_far = R(-1), second = R(2), iso = R(0), middle = R(0);
  Mask<R> crosses = Mask<R>(false), rises = Mask<R>(false);

  ISO_HD void add(Mask<R> possible, int i, R lo, R hi, R guess, Mask<R> does_cross, Mask<R> does_rise) {
    const Mask<R> nearer = possible & (lo < near);
    second = select(nearer, near, select(possible, min(second, lo), second));
    near = select(nearer, lo, near);
    far = select(possible, max(far, hi), far);
    first_far = select(nearer, hi, first_far);
    iso = select(nearer, R(static_cast<Scalar<R>>(i)), iso);
    middle = select(nearer, guess, middle);
    crosses = select(nearer, does_cross, crosses);
    rises = select(nearer, does_rise, rises);
  }
  /// The first root is a crossing, and no other one is mixed up with it.
  ISO_HD Mask<R> alone() const { return crosses & (first_far <= second); }
};

/// All of [lo, hi] for each iso-value that f holds: an interval says no more.
template <Real R>
ISO_HD inline Levels<R> find_levels(const Interval<R>& f, R lo, R hi, const FormulaQuery<Scalar<R>>& query) {
  Levels<R> levels;
  const Mask<R> no = Mask<R>(false);
  for (int i = 0; i < query.iso_count; ++i) {
    const Sides<R> s = sides_of(f, query, i);
    levels.add(!(s.below | s.above | f.empty), i, lo, hi, R(0.5) * (lo + hi), no, no);
  }
  return levels;
}

/// What is left of E in [-1, 1] where c + e E +- r may be an iso-value. Strictly inside, where f is
/// continuous, it holds a crossing; trimmed again and again it shrinks quadratically.
template <Real R>
ISO_HD inline Levels<R> find_levels(const AffineForm<R, 1>& f, R lo, R hi,
                                    const FormulaQuery<Scalar<R>>& query) {
  using T = Scalar<R>;
  Levels<R> levels;
  const R half = R(0.5) * (hi - lo), middle = lo + half, inverse = R(1) / f.e[0];
  for (int i = 0; i < query.iso_count; ++i) {
    const R iso = R(query.iso_lo[i]), c = f.c - iso;
    const R radius = f.r + (R(query.iso_hi[i]) - iso) + R(kSpacing<T>) * (abs(f.c) + abs(c));
    const R centre = -c * inverse, width = radius * abs(inverse);
    const R slack = R(T(8) * kSpacing<T>) * (abs(centre) + width + R(1));
    // a NaN keeps everything
    const R first = centre - width - slack, last = centre + width + slack;
    const Mask<R> outside = (first > R(1)) | (last < R(-1)), inside = (first > R(-1)) & (last < R(1));
    const R from = select(inside | (first > R(-1)), first, R(-1)), to = select(last < R(1), last, R(1));
    const R rounding = R(T(4) * kSpacing<T>);
    levels.add(!(outside | f.empty), i, max(lo, middle + from * half - rounding),
               min(hi, middle + to * half + rounding), min(max(middle + centre * half, lo), hi),
               inside & f.continuous, f.e[0] > R(0));
  }
  return levels;
}

}  // namespace isocast::inline ISO_ISA
