// Rays in work, and what is known of the sides on which they are.
#pragma once

#include <isocast/implicit/solve/slots.h>
#include <isocast/implicit/solve/verdict.h>

namespace isocast::inline ISO_ISA {

/// The slots of a solver with the formula that they look at and the roots that they fill.
template <Real R> struct Rays : Slots<R> {
  using T = Scalar<R>;
  using Base = Slots<R>;
  using Base::below, Base::carried, Base::get, Base::known, Base::ray;

  const FormulaQuery<T>& query;
  SegmentRoots<T>& roots;

  ISO_HD Rays(const FormulaQuery<T>& formula, SegmentRoots<T>& found) : query(formula), roots(found) {}

  ISO_HD R smallest_part(int p) const { return max(get(kSmallestPart, p), R(kLeast<T>)); }

  /// Sides of each iso-value at the ends of a small part.
  ISO_HD Ends<R> ends_of(int p, const Interval<R>& at_end) const {
    Ends<R> ends{query, at_end, {}, {}};
    const Mask<R> known_here = lanes_of<R>(known, p);
    for (int i = 0; i < isos_in(query); ++i) {
      const Mask<R> under = lanes_of<R>(below[i], p);
      const Sides<R> s = sides_of(at_end, query, i);
      ends.near[i].below = known_here & under;
      ends.near[i].above = known_here & !under;
      ends.far[i].below = s.below & at_end.defined;
      ends.far[i].above = s.above & at_end.defined;
    }
    return ends;
  }
  /// f is off every iso-value, on known sides.
  ISO_HD Mask<R> sides_known(const Interval<R>& f) const {
    Mask<R> all = f.defined;
    for (int i = 0; i < isos_in(query); ++i) {
      const Sides<R> s = sides_of(f, query, i);
      all = all & (s.below | s.above);
    }
    return all;
  }
  ISO_HD void forget_sides(int p, Mask<R> where) { put_lanes<R>(known, p, lanes_of<R>(known, p) & !where); }
  /// Remembers the sides that f has, in these lanes, where every iso-value is left out.
  ISO_HD void note_sides(int p, Mask<R> where, const Interval<R>& f) {
    for (int i = 0; i < isos_in(query); ++i)
      put_lanes<R>(below[i], p, select(where, sides_of(f, query, i).below, lanes_of<R>(below[i], p)));
    put_lanes<R>(known, p, select(where, sides_known(f), lanes_of<R>(known, p)));
  }
  /// Whether f < iso where the ray has come to, for an iso-value per lane.
  ISO_HD Mask<R> is_below(int p, R iso) const {
    Mask<R> result = Mask<R>(false);
    for (int i = 0; i < isos_in(query); ++i) result = result | ((iso == R(T(i))) & lanes_of<R>(below[i], p));
    return result;
  }
  ISO_HD Mask<R> at_known_start(int p, R s) const { return lanes_of<R>(carried, p) & (s == get(kStart, p)); }

  ISO_HD void doubt(int p, Mask<R> where) {
    this->for_lanes(p, where, [this](int, int ray) { roots.proved[ray] = false; });
  }
};

}  // namespace isocast::inline ISO_ISA
