// Beams are cut to where f may be an iso-value for any of their rays.
#pragma once

#include <isocast/implicit/solve/beam.h>
#include <isocast/implicit/solve/levels.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// Looks at slabs of all beams at once: 64 of one beam, or four of each of sixteen. What the inclusions, and
/// their trimming, prove empty at both ends is cut off.
///
/// F          Interval<R> or AffineForm<R, 1>, whose symbol follows k
/// registers  room for Slots<R>::kPacks of F a register
/// source     Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval
///            arithmetic, SIBGRAPI 2011, without their subdivision of the beams' sections
template <class F, Real R>
ISO_HD inline void narrow_beams(const FormulaQuery<Scalar<R>>& query, BeamStream<Scalar<R>>& beams,
                                void* registers) {
  using T = Scalar<R>;
  constexpr int kPacks = Slots<R>::kPacks;
  const int slabs = beams.count == 1 ? kSlots : kSlots / kMostBeams, lanes = beams.count * slabs,
            packs = (lanes + kWidth<R> - 1) / kWidth<R>;
  T e[3][kSlots], d[3][kSlots], slack[3][kSlots], lo[kSlots], hi[kSlots];
  for (int l = 0; l < packs * kWidth<R>; ++l) {
    const int b = (l < lanes ? l : lanes - 1) / slabs, slab = l % slabs;
    const T from = beams.from[b], to = beams.to[b], length = to - from, share = T(1) / T(slabs);
    lo[l] = slab == 0 ? from : from + length * (T(slab) * share);
    hi[l] = slab == slabs - 1 ? to : from + length * (T(slab + 1) * share);
    for (int a = 0; a < 3; ++a) {
      e[a][l] = beams.e[a][b], d[a][l] = beams.d[a][b];
      slack[a][l] = beams.slack[a][b] + max(hi[l], T(0)) * beams.spread[a][b];
    }
  }
  F inputs[4 * kPacks];
  for (int p = 0; p < packs; ++p) {
    const auto row = [at = p * kWidth<R>](const T(&field)[3][kSlots]) {
      return [&field, at](int a) { return load<R>(field[a] + at); };
    };
    RayPart<R>(load<R>(lo + p * kWidth<R>), load<R>(hi + p * kWidth<R>))
        .template put<kPacks>(inputs, p, query.time, row(e), row(d), row(slack));
  }
  const F* const f =
      evaluate_some<kPacks>(query.tape, static_cast<const F*>(inputs), static_cast<F*>(registers), packs);
  T near[kSlots], far[kSlots];
  for (int p = 0; p < packs; ++p) {
    const R first = load<R>(lo + p * kWidth<R>), last = load<R>(hi + p * kWidth<R>);
    const Interval<R> range = interval_of(f[p]);
    const Levels<R> levels =
        query.options.trim ? find_levels(f[p], first, last, query) : find_levels(range, first, last, query);
    const Mask<R> out = leaves_out(range, query) | (first > last);
    store(near + p * kWidth<R>, select(out, R(2), levels.near));
    store(far + p * kWidth<R>, select(out, R(-1), levels.far));
  }
  beams.evaluations += lanes;
  for (int b = 0; b < beams.count; ++b) {
    T from = T(2), to = T(-1);
    for (int l = b * slabs; l < (b + 1) * slabs; ++l) {
      if (!(near[l] <= far[l])) continue;
      from = min(from, near[l]), to = max(to, far[l]);
    }
    beams.from[b] = from, beams.to[b] = to;
  }
}

}  // namespace isocast::inline ISO_ISA
