// Parts of beams side by side: f over each, and where in it f may be an iso-value.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/narrow_beams.h>

namespace isocast::inline ISO_ISA {

/// As many parts of beams at once.
inline constexpr int kBeamLanes = kSlots;

/// Of parts of beams: f has one side of each iso-value in all of it for sure (bit i of `below` set: f < iso
/// i); f is defined and continuous.
template <class T> struct CellSides {
  std::uint32_t below[kBeamLanes];
  bool sure[kBeamLanes], continuous[kBeamLanes];
};

/// Parts of beams in structure of arrays: pixels within `half` of (u, v), depths from `from` to `to` behind
/// the plane at + (u' - u) along_u + (v' - v) along_v, of which those in the window are asked for.
///
/// open      the part may hold roots: those that are asked for lie in the window next_from, next_to, and from
///           `near` to `far` behind the plane
/// narrow    every ray has one crossing there, in a bracket of at most eps
/// straight  the roots lie close to a plane, compared with the part
/// next_at, next_u, next_v, radius  narrow or straight: the plane, and how close in depth
/// rises, slope, iso                narrow: what crosses, and df/dt
template <Real R> struct BeamLanes {
  using T = Scalar<R>;
  static constexpr int kPacks = kBeamLanes / kWidth<R>;
  /// How close, as a share of the part's depth or of that over which the plane slants.
  static constexpr T kStraight = T(0.25);

  int count = 0;
  alignas(64) T u[kBeamLanes], v[kBeamLanes], half[kBeamLanes], at[kBeamLanes], along_u[kBeamLanes],
      along_v[kBeamLanes], from[kBeamLanes], to[kBeamLanes];
  alignas(64) T window_from[kBeamLanes], window_to[kBeamLanes];
  alignas(64) T near[kBeamLanes], far[kBeamLanes], next_from[kBeamLanes], next_to[kBeamLanes],
      next_at[kBeamLanes], next_u[kBeamLanes], next_v[kBeamLanes], radius[kBeamLanes], slope[kBeamLanes],
      iso[kBeamLanes];
  SlotBits open = 0, narrow = 0, straight = 0, rises = 0;

  /// One part more, of a node: the rays through the middles of its pixels.
  ISO_HD void add(const BeamNode<T>& node, DepthRange<T> part) {
    const T middle = T(0.5) * T(node.size - 1), side = T(0.5) * T(kBlockSide - 1);
    add(T(node.x) + middle - side, T(node.y) + middle - side, middle, part);
    const int l = count - 1;
    at[l] = node.at, along_u[l] = node.along_u, along_v[l] = node.along_v;
    window_from[l] = node.window.from, window_to[l] = node.window.to;
  }
  /// One part more: all rays within `at_half` pixels of (at_u, at_v).
  ISO_HD void add(T at_u, T at_v, T at_half, DepthRange<T> part) {
    const int l = count++;
    u[l] = at_u, v[l] = at_v, half[l] = at_half;
    at[l] = along_u[l] = along_v[l] = T(0);
    from[l] = part.from, to[l] = part.to;
    window_from[l] = part.from, window_to[l] = part.to;
  }

  /// Looks at all parts.
  ///
  /// F          Interval<R>, which finds no crossings, or an affine form with three symbols
  /// registers  room for kPacks of F a register
  template <class F>
  ISO_HD void look(const FormulaQuery<T>& query, const BlockRays<T>& rays, void* registers) {
    const F* const f = evaluate<F>(query, rays, registers);
    for (int p = 0; p < packs(); ++p) judge(query, f[p], R(rays.eps), p);
  }

  /// Looks at the sides of all parts alone.
  template <class F>
  ISO_HD void look_at_sides(const FormulaQuery<T>& query, const BlockRays<T>& rays, void* registers,
                            CellSides<T>& sides) {
    const F* const f = evaluate<F>(query, rays, registers);
    for (int p = 0; p < packs(); ++p) {
      const Interval<R> range = interval_of(f[p]);
      const Mask<R> defined = range.defined & !range.empty;
      const unsigned sure = bits_of(leaves_out(range, query) & defined),
                     continuous = bits_of(range.continuous & defined);
      for (int l = 0; l < kWidth<R>; ++l) {
        sides.sure[p * kWidth<R> + l] = sure >> l & 1;
        sides.continuous[p * kWidth<R> + l] = continuous >> l & 1;
        sides.below[p * kWidth<R> + l] = 0;
      }
      for (int i = 0; i < query.iso_count; ++i)
        for (unsigned rest = bits_of(sides_of(range, query, i).below); rest; rest &= rest - 1)
          sides.below[p * kWidth<R> + __builtin_ctz(rest)] |= 1u << i;
    }
  }

 private:
  ISO_HD int packs() const { return kPacks == 1 ? 1 : (count + kWidth<R> - 1) / kWidth<R>; }

  // f over all parts, a pack of them at a time.
  template <class F>
  ISO_HD const F* evaluate(const FormulaQuery<T>& query, const BlockRays<T>& rays, void* registers) {
    if constexpr (kWidth < R >> 1)
      for (int l = count; l < packs() * kWidth<R>; ++l) repeat(count - 1, l);
    F inputs[4 * kPacks];
    for (int p = 0; p < packs(); ++p) put_inputs(query, rays, p, inputs);
    return evaluate_some<kPacks>(query.tape, static_cast<const F*>(inputs), static_cast<F*>(registers),
                                 packs());
  }

  ISO_HD void repeat(int from_lane, int l) {
    u[l] = u[from_lane], v[l] = v[from_lane], half[l] = half[from_lane];
    at[l] = at[from_lane], along_u[l] = along_u[from_lane], along_v[l] = along_v[from_lane];
    from[l] = from[from_lane], to[l] = to[from_lane];
    window_from[l] = window_from[from_lane], window_to[l] = window_to[from_lane];
  }
  ISO_HD static R get(const T (&values)[kBeamLanes], int p) { return load<R>(values + p * kWidth<R>); }
  ISO_HD static void put(T (&values)[kBeamLanes], int p, R value) { store(values + p * kWidth<R>, value); }

  template <class F>
  ISO_HD void put_inputs(const FormulaQuery<T>& query, const BlockRays<T>& rays, int p, F* inputs) const {
    const R u0 = get(u, p), v0 = get(v, p), h = get(half, p), pu = get(along_u, p), pv = get(along_v, p);
    const R k0 = get(from, p), k1 = get(to, p), middle = R(T(0.5)) * (k0 + k1);
    // a little more than half of it, so that neighbours overlap
    const R deep = R(T(0.5)) * (k1 - k0) + R(T(2) * kSpacing<T>) * (abs(k0) + abs(k1));
    const R t = get(at, p) + middle, tilt = h * (abs(pu) + abs(pv)), size = abs(t) + deep + tilt;
    for (int a = 0; a < 3; ++a) {
      const R su = R(rays.start_u[a]), sv = R(rays.start_v[a]), du = R(rays.span_u[a]),
              dv = R(rays.span_v[a]);
      const R d = R(rays.span[a]) + u0 * du + v0 * dv;
      AffineForm<R, 3> x;
      x.c = R(rays.start[a]) + u0 * su + v0 * sv + t * d;
      x.e[0] = deep * d;
      x.e[1] = h * (su + t * du + pu * d);
      x.e[2] = h * (sv + t * dv + pv * d);
      const R twist = h * (abs(du) + abs(dv)),
              bend = h * h * (abs(pu * du) + abs(pv * dv) + abs(pu * dv + pv * du));
      x.r = raised(R(rays.slack[a]) + size * R(rays.spread[a]) + deep * twist + bend);
      x.defined = x.continuous = Mask<R>(true);
      x.empty = Mask<R>(false);
      as_input(x, inputs[a * kPacks + p]);
    }
    inputs[3 * kPacks + p] = constant_as({query.time, true}, F{});
  }
  ISO_HD static void as_input(const AffineForm<R, 3>& x, AffineForm<R, 3>& y) { y = x; }
  ISO_HD static void as_input(const AffineForm<R, 3>& x, Interval<R>& y) { y = interval_of(x); }

  template <class F> ISO_HD void judge(const FormulaQuery<T>& query, const F& f, R eps, int p) {
    const BeamLevels<R> found = find_beam_levels(f, R(T(0)), R(T(1)), query);
    const Mask<R> out = leaves_out(interval_of(f), query) | (found.levels.near > found.levels.far),
                  single = found.levels.second > R(T(1));
    const R start = get(from, p), end = get(to, p), depth = end - start, h = get(half, p),
            pu = get(along_u, p), pv = get(along_v, p), plane = get(at, p);
    const R tilt = h * (abs(pu) + abs(pv));
    const R rounding = R(T(8) * kSpacing<T>) * (abs(plane) + tilt + abs(start) + abs(end));
    const R k0 = start + found.levels.near * depth - rounding,
            k1 = start + found.levels.far * depth + rounding;
    const R first = max(get(window_from, p), plane - tilt + k0),
            last = min(get(window_to, p), plane + tilt + k1);
    put(near, p, k0), put(far, p, k1), put(next_from, p, first), put(next_to, p, last);
    put_lanes<R>(open, p, !(out | (first > last)));

    // the plane of the crossing
    const R per_pixel = select(h > R(T(0)), depth / max(h, R(T(0.5))), R(T(0)));
    const R u1 = pu + found.along_u * per_pixel, v1 = pv + found.along_v * per_pixel,
            at1 = plane + (start + found.at * depth), tilt1 = h * (abs(u1) + abs(v1));
    const R distance = found.radius * depth + rounding + R(T(8) * kSpacing<T>) * (abs(at1) + tilt1);
    const R slanted = abs(found.along_u) + abs(found.along_v);
    put(next_at, p, at1), put(next_u, p, u1), put(next_v, p, v1), put(radius, p, distance);
    put_lanes<R>(straight, p, single & (found.radius <= R(kStraight) * max(R(T(1)), slanted)));
    put_lanes<R>(narrow, p, single & found.levels.alone() & (R(T(2)) * distance <= eps));
    put_lanes<R>(rises, p, found.levels.rises);
    put(slope, p, slope_of(f) / depth);
    put(iso, p, found.levels.iso);
  }
  ISO_HD static R slope_of(const AffineForm<R, 3>& f) { return R(T(2)) * f.e[0]; }
  ISO_HD static R slope_of(const Interval<R>&) { return R(T(0)); }
};

}  // namespace isocast::inline ISO_ISA
