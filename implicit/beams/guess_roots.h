// What was hit is guessed where no form proves it.
#pragma once

#include <isocast/implicit/beams/tile_lanes.h>

namespace isocast::inline ISO_ISA {

/// Of kSlots roots of a tile, from slot `first` of it on, that are not proved: the iso-value nearest to f at
/// the guess, and f's side of it at lo, in plain arithmetic. `registers` has room for kSlots / kWidth<R> of R
/// a register.
template <Real R>
ISO_HD inline void guess_roots(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
                               int tile, int first, PixelRoots<Scalar<R>>& roots, void* registers) {
  using T = Scalar<R>;
  constexpr int kPacks = TileLanes<R>::kPacks;
  const TileLanes<R> lanes(roots, tile, first, {-kInfinity<T>, kInfinity<T>});
  if (lanes.packs < 1) return;
  R t[kPacks], lo[kPacks], nearest[kPacks], level[kPacks];
  for (int p = 0; p < lanes.some_packs(); ++p)
    t[p] = lanes.get(roots.t, p, R(T(0))), lo[p] = lanes.get(roots.lo, p, R(T(0)));
  const R* f = lanes.evaluate(query, rays, t, registers);
  for (int p = 0; p < lanes.some_packs(); ++p) {
    nearest[p] = R(T(1)), level[p] = R(query.iso_lo[0]);
    for (int i = 1; i < isos_in(query); ++i) {
      const Mask<R> nearer = abs(f[p] - R(query.iso_lo[i])) < abs(f[p] - level[p]);
      nearest[p] = select(nearer, R(T(i + 1)), nearest[p]);
      level[p] = select(nearer, R(query.iso_lo[i]), level[p]);
    }
  }
  f = lanes.evaluate(query, rays, lo, registers);
  for (int p = 0; p < lanes.some_packs(); ++p)
    store(roots.side + lanes.slots[p], select(f[p] < level[p], nearest[p], -nearest[p]));
}

}  // namespace isocast::inline ISO_ISA
