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
  for (int i = 0; i < isos_in(query); ++i) {
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
/// resume     behind far, none before it
/// crosses    in the first one f goes from one side of its iso-value to the other, and is continuous
/// rises      it goes up
template <Real R> struct Levels {
  R near = R(2), far = R(-1), first_far = R(-1), second = R(2), resume = R(2), iso = R(0), middle = R(0);
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
  ISO_HD void replace(Mask<R> where, const Levels& other) {
    const auto put = [where](auto& mine, const auto& found) { mine = select(where, found, mine); };
    put(near, other.near), put(far, other.far), put(first_far, other.first_far), put(second, other.second);
    put(iso, other.iso), put(middle, other.middle), put(crosses, other.crosses), put(rises, other.rises);
  }
  /// The first root is a crossing, and no other one is mixed up with it.
  ISO_HD Mask<R> alone() const { return crosses & (first_far <= second); }
};

/// All of [lo, hi] for each iso-value that f holds: an interval says no more.
template <Real R>
ISO_HD inline Levels<R> find_levels(const Interval<R>& f, R lo, R hi, const FormulaQuery<Scalar<R>>& query) {
  Levels<R> levels;
  const Mask<R> no = Mask<R>(false);
  for (int i = 0; i < isos_in(query); ++i) {
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
  for (int i = 0; i < isos_in(query); ++i) {
    const R iso = R(query.iso_lo[i]), c = f.c - iso;
    const R radius = with_roundings(f.r + (R(query.iso_hi[i]) - iso), abs(f.c) + abs(c));
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

/// f over a part, its derivative there, and its value in the middle: the interval Newton method's.
template <Real R> struct NewtonForm { Interval<R> range, slope, at_middle; };
template <Real R> ISO_HD inline const Interval<R>& interval_of(const NewtonForm<R>& f) { return f.range; }

/// What the mean value theorem leaves: m - (f(m) - iso) / f', which is two pieces where f' holds zero.
/// Strictly inside the part it holds one root.
/// source  R. E. Moore, R. B. Kearfott, M. J. Cloud: Introduction to interval analysis, SIAM 2009, chapter 8
template <Real R>
ISO_HD inline Levels<R> find_levels(const NewtonForm<R>& f, R lo, R hi,
                                    const FormulaQuery<Scalar<R>>& query) {
  Levels<R> levels;
  const R m = R(0.5) * (lo + hi);
  const Mask<R> smooth = f.slope.defined & f.range.continuous;
  const Mask<R> monotone = smooth & ((f.slope.lo > R(0)) | (f.slope.hi < R(0)));
  R second_piece = R(2);
  for (int i = 0; i < isos_in(query); ++i) {
    const Interval<R> g = f.at_middle - Interval<R>(R(query.iso_lo[i]), R(query.iso_hi[i]));
    const Interval<R> newton = Interval<R>(m) - g / f.slope;
    const Mask<R> inside = monotone & (newton.lo > lo) & (newton.hi < hi);
    const Mask<R> none = (monotone & ((newton.lo > hi) | (newton.hi < lo))) | f.range.empty;
    // f' of both signs and f(m) off the iso-value: nothing within |f(m)| / max |f'| of the middle
    const R least = select(g.lo > R(0), g.lo, select(g.hi < R(0), -g.hi, R(0)));
    const R steepest = max(abs(f.slope.lo), abs(f.slope.hi));
    const R away = down_exact_zero(down_exact_zero(least / steepest));
    const Mask<R> split = smooth & (!monotone) & (away > R(0)) & Mask<R>(isos_in(query) == 1);
    const R rounding = R(Scalar<R>(2) * kSpacing<Scalar<R>>);
    const Mask<R> near_piece = split & (m - away + rounding > lo);
    const R from =
        select(monotone, max(lo, newton.lo), select(split & !near_piece, min(m + away - rounding, hi), lo));
    const R to = select(monotone, min(hi, newton.hi), select(near_piece, min(m - away + rounding, hi), hi));
    second_piece = select(near_piece, max(min(m + away - rounding, hi), to), second_piece);
    levels.add(!none, i, from, max(from, to), R(0.5) * (from + to), inside, f.slope.lo > R(0));
  }
  levels.resume = second_piece;
  return levels;
}

}  // namespace isocast::inline ISO_ISA
