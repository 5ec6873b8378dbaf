// The roots of a block become hits.
#pragma once

#include <isocast/implicit/beams/tile_lanes.h>
#include <isocast/ray/hit.h>

namespace isocast::inline ISO_ISA {

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

/// Bit i: f < iso i in front of a root where f rises through iso-value `crossed`, or falls.
template <class T>
ISO_HD inline std::uint32_t sides_in_front(const FormulaQuery<T>& query, int crossed, bool rises) {
  std::uint32_t sides = std::uint32_t(rises) << crossed;
  for (int i = 0; i < query.iso_count; ++i)
    if (i != crossed) sides |= std::uint32_t(query.iso_lo[crossed] < query.iso_lo[i]) << i;
  return sides;
}

/// As many numbers as R has lanes.
template <Real R, class T> ISO_HD inline R widened(const T* values) {
  Scalar<R> y[kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l) y[l] = values[l];
  return load<R>(y);
}

/// Places of a tile's slots among its pixels.
struct TilePixels {
  alignas(64) double x[kStreamSize] = {}, y[kStreamSize] = {};
  constexpr TilePixels() {
    for (int i = 0; i < kStreamSize; ++i) x[i] = slot_x(i), y[i] = slot_y(i);
  }
};
inline constexpr TilePixels kTilePixels;

/// Puts the roots of a tile where hits holds none that are nearer; those of rays that
/// are unclear before them are left out.
template <Real R, class T>
ISO_HD inline void write_tile(const FormulaQuery<T>& query, const BlockRays<T>& rays,
                              const PixelRoots<T>& roots, int tile, std::uint16_t object,
                              Certificate certificate, HitStream& hits) {
  static_assert(__is_same(Scalar<R>, double));
  std::uint32_t sides[kMostIsos][2];
  for (int i = 0; i < query.iso_count; ++i)
    for (int rises = 0; rises < 2; ++rises) sides[i][rises] = sides_in_front(query, i, rises != 0);
  const int first = tile * kStreamSize;
  const R u = R(slot_x(first) - 0.5 * (kBlockSide - 1)), v = R(slot_y(first) - 0.5 * (kBlockSide - 1));
  for (int i = 0; i < kStreamSize; i += kWidth<R>) {
    const int slot = first + i;
    const R lo = widened<R>(roots.lo + slot);
    const Mask<R> found = (abs(lo) < R(kInfinity<double>)) & !(widened<R>(roots.unclear + slot) < lo);
    if (!any(found)) continue;
    const R at_u = u + load<R>(kTilePixels.x + i), at_v = v + load<R>(kTilePixels.y + i);
    R squared = R(0);
    for (int a = 0; a < 3; ++a) {
      const R d = R(rays.exact[a]) + at_u * R(rays.exact_u[a]) + at_v * R(rays.exact_v[a]);
      squared = squared + d * d;
    }
    const R per_depth = sqrt(squared), rounding = R(0x1p-49);
    const auto distance = [&](R depth) { return (R(rays.depth) + depth) * per_depth; };
    const R distance_t = distance(widened<R>(roots.t + slot)), distance_lo = distance(lo),
            distance_hi = distance(widened<R>(roots.hi + slot));
    const R slack = rounding * (abs(distance_hi) + abs(distance_lo) + abs(R(rays.depth)) * per_depth);
    const Mask<R> nearer = found & (distance_t < load<R>(hits.t + i));
    const auto put = [&](double* values, R value) {
      store(values + i, select(nearer, value, load<R>(values + i)));
    };
    put(hits.t, distance_t);
    put(hits.t_lo, distance_lo - slack), put(hits.t_hi, distance_hi + slack);
    for (unsigned rest = bits_of(nearer); rest; rest &= rest - 1) {
      const int k = i + __builtin_ctz(rest);
      const T side = roots.side[first + k];
      const int crossed = static_cast<int>(abs(side)) - 1;
      hits.iso[k] = static_cast<std::uint8_t>(crossed);
      hits.sides[k] = sides[crossed][side > T(0)];
      hits.object[k] = object;
      hits.certificate[k] = certificate;
    }
  }
}

}  // namespace isocast::inline ISO_ISA
