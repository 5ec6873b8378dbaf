// The roots of a block become hits.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/slots.h>
#include <isocast/ray/hit.h>

namespace isocast::inline ISO_ISA {

template <class T> ISO_HD inline int crossed_iso(const BlockRoots<T>& roots, int slot) {
  return static_cast<int>(abs(roots.side[slot])) - 1;
}

/// The best guesses at the roots of a tile: steps of the secant method in plain arithmetic, from the middle
/// of the bracket and the slope that the form had, kept in the bracket. Proves nothing and changes no proof.
/// `registers` has room for kSlots / kWidth<R> of R a register.
template <Real R>
ISO_HD inline void polish_tile(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
                               int tile, BlockRoots<Scalar<R>>& roots, void* registers) {
  using T = Scalar<R>;
  constexpr int kPacks = kSlots / kWidth<R>, kSteps = sizeof(T) == 4 ? 2 : 4;
  const int x0 = tile % (kBlockSide / 16) * 16, y0 = tile / (kBlockSide / 16) * 16;
  for (int first = 0; first < kStreamSize; first += kSlots) {
    int slots[kPacks], packs = 0;
    R u[kPacks], v[kPacks], t[kPacks], lo[kPacks], hi[kPacks], slope[kPacks], iso[kPacks], before[kPacks];
    for (int i = first; i < first + kSlots; i += kWidth<R>) {
      const int slot = tile * kStreamSize + i;
      const R found_lo = load<R>(roots.lo + slot);
      const Mask<R> found = abs(found_lo) < R(kInfinity<T>);
      if (!any(found)) continue;
      T at_u[kWidth<R>], at_v[kWidth<R>], level[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) {
        const int p = (i + l) / kPacketSize, k = (i + l) % kPacketSize;
        at_u[l] = T(x0 + p % 4 * 4 + k % 4) - T(0.5) * T(kBlockSide - 1);
        at_v[l] = T(y0 + p / 4 * 4 + k / 4) - T(0.5) * T(kBlockSide - 1);
        level[l] = abs(roots.lo[slot + l]) < kInfinity<T> ? query.iso_lo[crossed_iso(roots, slot + l)] : T(0);
      }
      u[packs] = load<R>(at_u), v[packs] = load<R>(at_v), iso[packs] = load<R>(level);
      lo[packs] = select(found, found_lo, R(T(0))),
      hi[packs] = select(found, load<R>(roots.hi + slot), R(T(0)));
      t[packs] = select(found, load<R>(roots.t + slot), R(T(0)));
      slope[packs] = select(found, load<R>(roots.slope + slot), R(T(1)));
      before[packs] = R(T(0));
      slots[packs++] = slot;
    }
    for (int step = 0; step < kSteps && packs > 0; ++step) {
      R inputs[4 * kPacks];
      for (int p = 0; p < packs; ++p) {
        for (int a = 0; a < 3; ++a)
          inputs[a * kPacks + p] =
              R(rays.start[a]) + u[p] * R(rays.start_u[a]) + v[p] * R(rays.start_v[a]) +
              t[p] * (R(rays.span[a]) + u[p] * R(rays.span_u[a]) + v[p] * R(rays.span_v[a]));
        inputs[3 * kPacks + p] = R(static_cast<T>(query.time));
      }
      const R* const f =
          evaluate_some<kPacks>(query.tape, static_cast<const R*>(inputs), static_cast<R*>(registers), packs);
      for (int p = 0; p < packs; ++p) {
        const R value = f[p] - iso[p], moved = value / slope[p];
        // f changed by value - before over the last step, where the slope foretold -before
        const R better = slope[p] * ((before[p] - value) / before[p]);
        const Mask<R> usable = Mask<R>(step > 0) & (better * slope[p] > R(T(0)));
        const R next = t[p] - select(usable, value / better, moved);
        slope[p] = select(usable, better, slope[p]);
        before[p] = value;
        t[p] = select(next == next, min(max(next, lo[p]), hi[p]), t[p]);
      }
    }
    for (int p = 0; p < packs; ++p) store(roots.t + slots[p], t[p]);
  }
}

/// Bit i: f < iso i in front of the root in a slot.
template <class T>
ISO_HD inline std::uint32_t sides_in_front(const FormulaQuery<T>& query, const BlockRoots<T>& roots,
                                           int slot) {
  const int crossed = crossed_iso(roots, slot);
  std::uint32_t sides = std::uint32_t(roots.side[slot] > T(0)) << crossed;
  for (int i = 0; i < query.iso_count; ++i)
    if (i != crossed) sides |= std::uint32_t(query.iso_lo[crossed] < query.iso_lo[i]) << i;
  return sides;
}

/// Puts the roots of a tile, all of them proved, where hits holds none that are nearer; those of rays that
/// are unclear before them are left out.
template <Real R, class T>
ISO_HD inline void write_tile(const FormulaQuery<T>& query, const BlockRays<T>& rays,
                              const BlockRoots<T>& roots, int tile, std::uint16_t object, HitStream& hits) {
  static_assert(__is_same(Scalar<R>, double));
  const int x0 = tile % (kBlockSide / 16) * 16, y0 = tile / (kBlockSide / 16) * 16, slot = tile * kStreamSize;
  for (int i = 0; i < kStreamSize; i += kWidth<R>) {
    double at_u[kWidth<R>], at_v[kWidth<R>], t[kWidth<R>], lo[kWidth<R>], hi[kWidth<R>], unclear[kWidth<R>];
    for (int l = 0; l < kWidth<R>; ++l) {
      const int p = (i + l) / kPacketSize, k = (i + l) % kPacketSize;
      at_u[l] = x0 + p % 4 * 4 + k % 4 - 0.5 * (kBlockSide - 1);
      at_v[l] = y0 + p / 4 * 4 + k / 4 - 0.5 * (kBlockSide - 1);
      const int s = slot + i + l;
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
      hits.certificate[k] = Certificate::proved_hit;
    }
  }
}

}  // namespace isocast::inline ISO_ISA
