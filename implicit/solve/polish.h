// The best guess at roots that are isolated already.
#pragma once

#include <isocast/implicit/solve/hit_lanes.h>

namespace isocast::inline ISO_ISA {

/// Newton's steps in plain arithmetic from `s` of every proved hit, kept between s_lo and s_hi: each doubles
/// the digits, from the few that isolation leaves to those of T. Proves nothing and changes no proof.
/// `registers` has room for HitLanes<R>::kPacks of Gradient<R> a register.
template <Real R>
ISO_HD inline void polish(const FormulaQuery<Scalar<R>>& query, const SegmentStream<Scalar<R>>& stream,
                          SegmentRoots<Scalar<R>>& roots, RayRange range, void* registers) {
  constexpr int kSteps = sizeof(Scalar<R>) == 4 ? 2 : 3;
  const auto work = [&](HitLanes<R>& lanes) {
    for (int step = 0; step < kSteps; ++step) {
      const Gradient<R>* const g = lanes.template evaluate<Gradient<R>>(query, registers);
      for (int p = 0; p < lanes.packs(); ++p) {
        const R slope = g[p].dx * lanes.d[0][p] + g[p].dy * lanes.d[1][p] + g[p].dz * lanes.d[2][p];
        const R next = lanes.s[p] - (g[p].value - lanes.iso[p]) / slope;
        lanes.s[p] = select(next == next, min(max(next, lanes.lo[p]), lanes.hi[p]), lanes.s[p]);
      }
    }
  };
  HitLanes<R>::each(
      query, stream, roots, range, [&](int i) { return roots.proved[i]; }, work);
}

}  // namespace isocast::inline ISO_ISA
