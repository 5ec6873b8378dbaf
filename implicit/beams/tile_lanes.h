// Roots of a tile side by side, for f at points of their rays.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// Slots of a tile with roots, up to kSlots of them side by side, and points of their rays.
template <Real R> struct TileLanes {
  using T = Scalar<R>;
  static constexpr int kPacks = kSlots / kWidth<R>;

  int slots[kPacks], packs = 0;
  R u[kPacks], v[kPacks];
  Mask<R> found[kPacks];

  /// The packs with roots from `range` among the kSlots slots of a tile from `first` on.
  ISO_HD TileLanes(const PixelRoots<T>& roots, int tile, int first, DepthRange<T> range) {
    for (int i = first; i < first + kSlots; i += kWidth<R>) {
      const int slot = tile * kStreamSize + i;
      const R lo = load<R>(roots.lo + slot);
      const Mask<R> some = (abs(lo) < R(kInfinity<T>)) & (lo >= R(range.from)) & (lo <= R(range.to));
      if (!any(some)) continue;
      T at_u[kWidth<R>], at_v[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) {
        at_u[l] = T(slot_x(slot + l)) - T(0.5) * T(kBlockSide - 1);
        at_v[l] = T(slot_y(slot + l)) - T(0.5) * T(kBlockSide - 1);
      }
      u[packs] = load<R>(at_u), v[packs] = load<R>(at_v), found[packs] = some;
      slots[packs++] = slot;
    }
  }
  /// A number of packs that is not 0: the compiler knows it where there is but one.
  ISO_HD int some_packs() const { return kPacks == 1 ? 1 : packs; }
  /// Values of the slots with roots, else `otherwise`.
  ISO_HD R get(const T* values, int p, R otherwise) const {
    return select(found[p], load<R>(values + slots[p]), otherwise);
  }
  /// f at these depths, where there are packs.
  ISO_HD const R* evaluate(const FormulaQuery<T>& query, const BlockRays<T>& rays, const R* t,
                           void* registers) const {
    R inputs[4 * kPacks];
    for (int p = 0; p < some_packs(); ++p) {
      for (int a = 0; a < 3; ++a)
        inputs[a * kPacks + p] =
            R(rays.start[a]) + u[p] * R(rays.start_u[a]) + v[p] * R(rays.start_v[a]) +
            t[p] * (R(rays.span[a]) + u[p] * R(rays.span_u[a]) + v[p] * R(rays.span_v[a]));
      inputs[3 * kPacks + p] = R(static_cast<T>(query.time));
    }
    return evaluate_some<kPacks>(query.tape, static_cast<const R*>(inputs), static_cast<R*>(registers),
                                 some_packs());
  }
};

}  // namespace isocast::inline ISO_ISA
