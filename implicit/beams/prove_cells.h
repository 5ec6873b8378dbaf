// Sixteenths of pixels that a surface is proved to cover.
#pragma once

#include <isocast/implicit/beams/beam_lanes.h>

namespace isocast::inline ISO_ISA {

/// Of the cells that casting has left (BlockCells::finest), those in pixels that are not wholly covered:
/// counts in `proved` the ones across all of which f changes its side of an iso-value, continuously. The
/// sides are those of the whole cross-section, by inclusion: where the part that is left begins, and one or
/// four brackets behind it.
template <class F, Real R>
ISO_HD inline void prove_cells(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
                               BlockCells<Scalar<R>>& cells, void* registers) {
  using T = Scalar<R>;
  const FinestCells<T> finest = cells.finest();
  const T scale = T(1) / T(1 << finest.finer), half = T(0.5) * scale, side = T(kBlockSide / 2);
  BeamLanes<R> lanes;
  int cell[kBeamLanes];
  cells.evaluations = 0;
  const auto slot_of = [&](int c) {
    return pixel_slot(finest.cells->x[c] >> finest.finer, finest.cells->y[c] >> finest.finer);
  };
  const auto look = [&](int count, const DepthRange<T>* parts, CellSides<T>& sides) {
    lanes.count = 0;
    for (int l = 0; l < count; ++l)
      lanes.add(T(finest.cells->x[cell[l]]) * scale + half - side,
                T(finest.cells->y[cell[l]]) * scale + half - side, half, parts[l]);
    lanes.template look_at_sides<F>(query, rays, registers, sides);
    cells.evaluations += count;
  };
  for (int i = 0; i < kBlockPixels; ++i) {
    const bool whole = cells.covered[i] == 1 << 2 * finest.finer;
    cells.proved[i] = whole ? cells.covered[i] : std::uint8_t(0);
  }
  for (int next = 0; next < finest.cells->count;) {
    int count = 0;
    for (; next < finest.cells->count && count < kBeamLanes; ++next) {
      const bool left = finest.cells->from[next] < kInfinity<T>;
      if (left && cells.covered[slot_of(next)] < 1 << 2 * finest.finer) cell[count++] = next;
    }
    if (count == 0) break;
    DepthRange<T> before[kBeamLanes], behind[kBeamLanes], between[kBeamLanes];
    CellSides<T> near, far, path;
    bool proved[kBeamLanes] = {};
    for (int l = 0; l < count; ++l) before[l] = {finest.cells->from[cell[l]], finest.cells->from[cell[l]]};
    look(count, before, near);
    constexpr T kBehind[2] = {1, 4};
    for (const T brackets : kBehind) {
      for (int l = 0; l < count; ++l) {
        const T to = finest.to[cell[l]], depth = to + brackets * (to - before[l].from);
        behind[l] = {depth, depth};
        between[l] = {before[l].from, depth};
      }
      look(count, behind, far);
      look(count, between, path);
      for (int l = 0; l < count; ++l)
        proved[l] =
            proved[l] || (near.sure[l] && far.sure[l] && path.continuous[l] && near.below[l] != far.below[l]);
    }
    for (int l = 0; l < count; ++l) cells.proved[slot_of(cell[l])] += std::uint8_t(proved[l]);
  }
}

}  // namespace isocast::inline ISO_ISA
