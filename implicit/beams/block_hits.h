// The roots of a block become hits.
#pragma once

#include <isocast/implicit/beams/tile_lanes.h>
#include <isocast/ray/hit.h>

namespace isocast::inline ISO_ISA {

template <class T> ISO_HD inline int crossed_iso(const PixelRoots<T>& roots, int slot) {
  return static_cast<int>(abs(roots.side[slot])) - 1;
}

/// The best guesses at the roots of a tile whose brackets begin in `range`: steps of the secant method in
/// plain arithmetic, from the middle of the bracket and the slope that the form had, kept in the bracket.
/// Proves nothing and changes no proof. `registers` has room for kSlots / kWidth<R> of R a register.
template <Real R>
ISO_HD inline void polish_tile(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
                               int tile, DepthRange<Scalar<R>> range, PixelRoots<Scalar<R>>& roots,
                               void* registers) {
  using T = Scalar<R>;
  constexpr int kPacks = TileLanes<R>::kPacks, kSteps = sizeof(T) == 4 ? 2 : 4;
  const R zero = R(T(0));
  for (int first = 0; first < kStreamSize; first += kSlots) {
    const TileLanes<R> lanes(roots, tile, first, range);
    R t[kPacks], lo[kPacks], hi[kPacks], slope[kPacks], iso[kPacks], before[kPacks];
    for (int p = 0; p < lanes.packs; ++p) {
      lo[p] = lanes.get(roots.lo, p, zero), hi[p] = lanes.get(roots.hi, p, zero);
      t[p] = lanes.get(roots.t, p, zero), slope[p] = lanes.get(roots.slope, p, R(T(1)));
      const R level = abs(lanes.get(roots.side, p, R(T(1)))) - R(T(1));
      iso[p] = R(query.iso_lo[0]);
      for (int i = 1; i < query.iso_count; ++i) iso[p] = select(level == R(T(i)), R(query.iso_lo[i]), iso[p]);
      before[p] = zero;
    }
    for (int step = 0; step < kSteps && lanes.packs > 0; ++step) {
      const R* const f = lanes.evaluate(query, rays, t, registers);
      for (int p = 0; p < lanes.packs; ++p) {
        const R value = f[p] - iso[p];
        // f changed by value - before over the last step, where the slope foretold -before
        const R better = slope[p] * ((before[p] - value) / before[p]);
        slope[p] = select(Mask<R>(step > 0) & (better * slope[p] > zero), better, slope[p]);
        const R next = t[p] - value / slope[p];
        before[p] = value;
        t[p] = select(next == next, min(max(next, lo[p]), hi[p]), t[p]);
      }
    }
    for (int p = 0; p < lanes.packs; ++p)
      store(roots.t + lanes.slots[p], select(lanes.found[p], t[p], load<R>(roots.t + lanes.slots[p])));
  }
}

/// Bit i: f < iso i in front of the root in a slot.
template <class T>
ISO_HD inline std::uint32_t sides_in_front(const FormulaQuery<T>& query, const PixelRoots<T>& roots,
                                           int slot) {
  const int crossed = crossed_iso(roots, slot);
  std::uint32_t sides = std::uint32_t(roots.side[slot] > T(0)) << crossed;
  for (int i = 0; i < query.iso_count; ++i)
    if (i != crossed) sides |= std::uint32_t(query.iso_lo[crossed] < query.iso_lo[i]) << i;
  return sides;
}

/// Puts the roots of a tile where hits holds none that are nearer; those of rays that
/// are unclear before them are left out.
template <Real R, class T>
ISO_HD inline void write_tile(const FormulaQuery<T>& query, const BlockRays<T>& rays,
                              const PixelRoots<T>& roots, int tile, std::uint16_t object,
                              Certificate certificate, HitStream& hits) {
  static_assert(__is_same(Scalar<R>, double));
  const int slot = tile * kStreamSize;
  for (int i = 0; i < kStreamSize; i += kWidth<R>) {
    double at_u[kWidth<R>], at_v[kWidth<R>], t[kWidth<R>], lo[kWidth<R>], hi[kWidth<R>], unclear[kWidth<R>];
    for (int l = 0; l < kWidth<R>; ++l) {
      const int s = slot + i + l;
      at_u[l] = slot_x(s) - 0.5 * (kBlockSide - 1), at_v[l] = slot_y(s) - 0.5 * (kBlockSide - 1);
      t[l] = roots.t[s], lo[l] = roots.lo[s], hi[l] = roots.hi[s], unclear[l] = roots.unclear[s];
    }
    const Mask<R> found = (abs(load<R>(lo)) < R(kInfinity<double>)) & !(load<R>(unclear) < load<R>(lo));
    if (!any(found)) continue;
    R squared = R(0);
    for (int a = 0; a < 3; ++a) {
      const R d = R(rays.exact[a]) + load<R>(at_u) * R(rays.exact_u[a]) + load<R>(at_v) * R(rays.exact_v[a]);
      squared = squared + d * d;
    }
    const R per_depth = sqrt(squared), rounding = R(0x1p-49);
    const auto distance = [&](const double* depth) { return (R(rays.depth) + load<R>(depth)) * per_depth; };
    const R distance_t = distance(t), distance_lo = distance(lo), distance_hi = distance(hi);
    const R slack = rounding * (abs(distance_hi) + abs(distance_lo) + abs(R(rays.depth)) * per_depth);
    const Mask<R> nearer = found & (distance_t < load<R>(hits.t + i));
    const auto put = [&](double* values, R value) {
      store(values + i, select(nearer, value, load<R>(values + i)));
    };
    put(hits.t, distance_t);
    put(hits.t_lo, distance_lo - slack), put(hits.t_hi, distance_hi + slack);
    for (unsigned rest = bits_of(nearer); rest; rest &= rest - 1) {
      const int k = i + __builtin_ctz(rest);
      hits.iso[k] = static_cast<std::uint8_t>(crossed_iso(roots, slot + k));
      hits.sides[k] = sides_in_front(query, roots, slot + k);
      hits.object[k] = object;
      hits.certificate[k] = certificate;
    }
  }
}

}  // namespace isocast::inline ISO_ISA
