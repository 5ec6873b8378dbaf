// Marmitt: the first root is isolated between the extrema of the cubic, then refined.
#pragma once

#include <isocast/volume/cell/cell.h>

namespace isocast::inline ISO_ISA {

/// |f| at an extremum that counts as touching zero with touch=1, in units of the largest corner value's
/// roundoff.
inline constexpr int kTouchUlps = 16;

/// The bracket of the first root of p in (begin, 1] (`hit` where there is one), cut at the extrema: it holds
/// this root alone. `touched` where an extremum before it reaches zero within `touch_tolerance` without
/// crossing; `touch_s` is the first such.
template <Real R> struct Isolated {
  Bracket<R> bracket;
  Mask<R> hit, touched;
  R touch_s;
};
template <Real R, class P>
ISO_HD inline Isolated<R> isolate_first_root(const P& p, const Cell<R>& cell, R touch_tolerance,
                                             Mask<R> turning) {
  const Mask<R> inside = cell.begin > R(0);
  const R f_entry = value_at_0(p),
          f_begin = any(inside) ? select(inside, eval(p, cell.begin), f_entry) : f_entry;
  Isolated<R> r{{cell.begin, R(1), with_carried_sign(cell, f_begin), value_at_1(p)},
                Mask<R>(false),
                Mask<R>(false),
                R(0)};
  Bracket<R>& b = r.bracket;

  // cut at an extremum inside: if f has changed sign there the root lies before it, otherwise behind
  if (any(turning)) {
    const Extrema<R> e = extrema(p);
    const R places[] = {e.first, e.second};
    for (const R s : places) {
      const Mask<R> within = turning & (s > b.lo) & (s < b.hi);
      const R fs = eval(p, s);
      const Mask<R> touches =
          within & (abs(fs) <= touch_tolerance) & (negative(fs) == negative(b.flo)) & !r.touched;
      r.touch_s = select(touches, s, r.touch_s);
      r.touched = r.touched | touches;
      narrow(b, s, fs, within);
    }
  }
  r.hit = negative(b.flo) != negative(b.fhi);
  return r;
}

/// The iteration on the isolated bracket, and the touch before it if that is asked for.
template <Real R, class P>
ISO_HD inline Root<R> first_root(const P& p, const Cell<R>& cell, const CellOptions& options, Mask<R> maybe,
                                 Mask<R> turning) {
  R touch_tolerance = R(-1);
  if (options.touch) {
    R largest = abs(cell.f[0]);
    for (int i = 1; i < 8; ++i) largest = max(largest, abs(cell.f[i]));
    touch_tolerance = largest * R(kTouchUlps * kUnitRoundoff<Scalar<R>>);
  }
  if (!any(maybe) && !options.touch)
    return {R(0), R(0), R(0), Mask<R>(false), Mask<R>(false), Mask<R>(false)};
  Isolated<R> r = isolate_first_root(p, cell, touch_tolerance, turning);
  Bracket<R>& b = r.bracket;
  const Mask<R> behind = negative(b.fhi), touched = r.touched;
  R s = b.lo;
  if (any(r.hit)) {
    const auto f = [&](R t) { return eval(p, t); };
    const auto df = [&](R t) { return eval_derivative(p, t); };
    if (options.adaptive) s = newton_bracketed(f, df, b, R(kTolerance<Scalar<R>>), r.hit);
    else if (options.bisection) s = bisect(f, b, options.iterations);
    else s = regula_falsi(f, b, options.iterations);
  }
  const Mask<R> hit = r.hit | touched, crossing_follows = touched & r.hit;
  return {select(touched, r.touch_s, s),
          select(touched, r.touch_s, b.lo),
          select(touched, r.touch_s, b.hi),
          hit,
          touched,
          behind != crossing_follows};
}

/// The same in Bernstein form: there are as many roots as changes of sign among the coefficients, or fewer by
/// two. None is a miss, one needs no isolation.
template <Real R>
ISO_HD inline Root<R> first_root(const BernsteinCubic<R>& p, const Cell<R>& cell,
                                 const CellOptions& options) {
  const Mask<R> n0 = negative(with_carried_sign(cell, p.c0)), n1 = negative(p.c1), n2 = negative(p.c2),
                n3 = negative(p.c3);
  const Mask<R> a = n0 != n1, b = n1 != n2, c = n2 != n3;
  const Mask<R> maybe = a | b | c, several = (a & b) | (b & c) | (a & c);
  return first_root(p, cell, options, maybe, options.touch ? Mask<R>(true) : several);
}

/// First root of the trilinear field along the chord; none if f is of one sign.
///
/// With stable=1 the cubic is in Bernstein form and its extrema come from a quadratic formula without
/// cancellation; stable=0 is the textbook's power form. Zero counts as positive. adaptive=1: bracketed Newton
/// until a step is below kTolerance of the chord, bracket at most twice that; adaptive=0: `iterations` steps
/// of regula falsi (or bisection), bracket as it falls.
///
/// misses   two roots between which |f| stays below about 8 unit roundoffs of max |corner|; see
/// docs/accuracy.md touch=1  an extremum that reaches zero within kTouchUlps without crossing is a hit,
/// marked undecided source   Marmitt, Kleer, Wald, Friedrich, Slusallek: Fast and accurate ray-voxel
/// intersection techniques for iso-surface
///          ray tracing, VMV 2004; the Bernstein variant is ours
template <Real R> ISO_HD inline Root<R> marmitt(const Cell<R>& cell, const CellOptions& options) {
  if (!options.stable)
    return first_root(textbook_cubic_along(cell), cell, options, Mask<R>(true), Mask<R>(true));
  return first_root(cubic_along(cell), cell, options);
}

}  // namespace isocast::inline ISO_ISA
