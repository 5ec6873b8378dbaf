// What a part of a ray turned out to be.
#pragma once

#include <isocast/implicit/solve/levels.h>

namespace isocast::inline ISO_ISA {

/// Parts of this length, in s, are not divided: below, their ends are hardly apart in the arithmetic.
template <class T> inline constexpr T kLeast = T(0);
template <> inline constexpr float kLeast<float> = 0x1p-21f;
template <> inline constexpr double kLeast<double> = 0x1p-44;

/// One part [lo, hi] of the rays of a pack, in their s.
///
/// busy       lanes with a ray
/// near, far  roots can be here only
/// resume     if not behind hi, where they can be again
/// end        a little behind far: f there has a side even where a root lies at far
/// finite     f is bounded
/// empty      no root, or (`doubt`) nothing can be said of the part: it touches a start on the surface, or f
///            is unbounded
/// accepted   `root` is reported, `proved` or not
/// small      short enough to be judged
/// stuck      cannot be told and is not to be divided
/// over       the ray ends without a hit
/// again      to be judged once more, with `reach`
template <Real R> struct Part {
  R lo, hi, near, far, end, reach, resume;
  Mask<R> busy, finite, empty, accepted, proved, small = Mask<R>(false), doubt = small, over = small,
                                                 stuck = small, again = small;
  Levels<R> root;

  /// Takes over what was found of other's lanes.
  ISO_HD void replace(Mask<R> where, const Part& other) {
    const auto put = [where](auto& mine, const auto& found) { mine = select(where, found, mine); };
    put(hi, other.hi), put(near, other.near), put(far, other.far), put(resume, other.resume);
    put(empty, other.empty), put(accepted, other.accepted), put(proved, other.proved),
        put(small, other.small);
    root.replace(where, other.root);
  }
  ISO_HD void widen(R smallest) {
    const R least = R(Scalar<R>(0.25) * kLeast<Scalar<R>>), length = far - near;
    end = min(far + max(max(min(R(0.5) * length, smallest), reach), least), R(1));
  }
};

/// The derivative of f along the ray over a part, and where f is continuous there.
template <Real R> struct Slope {
  Interval<R> value;
  Mask<R> continuous;
};

/// Where f lies at both ends of a part, iso-value by iso-value, and its inclusion at the far one.
template <Real R> struct Ends {
  const FormulaQuery<Scalar<R>>& query;
  Interval<R> f_far;
  Sides<R> near[kMostIsos], far[kMostIsos];
};

/// Decides small parts: where f is monotone, its sides at the ends tell; a crossing is narrowed down by one
/// step of the interval Newton method. At the last look the others are stuck or, where f is unbounded, in
/// doubt.
template <Real R>
ISO_HD inline void decide(Part<R>& part, const Slope<R>& slope, const Ends<R>& ends, Mask<R> last_look,
                          R smallest) {
  const Interval<R> d = slope.value;
  const Mask<R> monotone = d.defined & slope.continuous & ((d.lo > R(0)) | (d.hi < R(0)));
  Levels<R> roots;
  Mask<R> same = Mask<R>(true), hidden = Mask<R>(false);
  for (int i = 0; i < isos_in(ends.query); ++i) {
    const Sides<R> a = ends.near[i], b = ends.far[i];
    const Mask<R> rises = a.below & b.above, crosses = rises | (a.above & b.below);
    same = same & ((a.below & b.below) | (a.above & b.above));
    hidden = hidden | !(b.below | b.above);
    if (!any(crosses)) continue;
    const Interval<R> level(R(ends.query.iso_lo[i]), R(ends.query.iso_hi[i]));
    const Interval<R> newton = Interval<R>(part.end) - (ends.f_far - level) / d;
    const R lo = max(newton.lo, part.near), hi = max(min(newton.hi, part.end), lo);
    roots.add(crosses, i, lo, hi, R(0.5) * (lo + hi), crosses, rises);
  }
  const Mask<R> empty = part.small & monotone & same, alone = part.small & monotone & roots.alone();
  const Mask<R> accepted =
      alone & ((roots.first_far - roots.near <= smallest) | (part.hi - part.lo <= smallest));
  part.near = select(alone, roots.near, part.near);
  part.far = select(alone, min(roots.first_far, part.hi), part.far);
  // f's side at the end is hidden by roundings: twice as far as they reach it is not
  const R reach = R(2) * (ends.f_far.hi - ends.f_far.lo) / min(abs(d.lo), abs(d.hi));
  part.again = part.small & monotone & hidden & (!last_look) & (part.end < R(1)) &
               (reach > R(2) * max(part.reach, part.end - part.far)) & (reach < R(1)) & !(empty | accepted);
  part.reach = select(part.again, reach, part.reach);
  const Mask<R> unclear = part.small & last_look & !(empty | accepted);
  part.doubt = unclear & !part.finite;
  part.stuck = unclear & !part.doubt;
  part.hi = select(empty, part.end, part.hi);
  part.empty = part.empty | empty | part.doubt;
  part.accepted = part.accepted | accepted;
  part.proved = part.proved | accepted;
  part.root.replace(accepted, roots);
}

}  // namespace isocast::inline ISO_ISA
