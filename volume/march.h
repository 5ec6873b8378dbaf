// From one active cell to the next: the walk, with the blocks that let it leap.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

/// Walks on to a cell whose corners enclose an iso-value and returns their bits, or 0 at the end of the ray.
/// `tested`: the current cell is done with. Grid: DenseGrid or SparseGrid.
template <class Grid>
ISO_HD inline std::uint32_t march(const Grid& grid, const GridRay& ray, GridWalk<Grid::kLevels>& walk,
                                  typename Grid::Place& place, bool tested, TraceCounts& counts) {
  std::uint32_t active = 0;
  std::int64_t cells = 0, macrocells = 0;
  const auto test = [&](auto level, const std::int32_t(&b)[3]) {
    if constexpr (level == GridWalk<Grid::kLevels>::kCells) {
      ++cells;
      active = grid.active_isos(b, place);
      return active != 0;
    } else {
      ++macrocells;
      return grid.block_active(level, b, place);
    }
  };
  // on the walk's level; whether it goes on
  const auto step = [&](auto level) {
    const bool found = walk_level<level>(ray, grid.shifts, walk, tested,
                                         [&](const std::int32_t(&b)[3]) { return test(level, b); });
    if constexpr (level == GridWalk<Grid::kLevels>::kCells) {
      if (found) return false;
    } else if (found) descend<level>(ray, grid.shifts, walk);
    tested = false;
    return found || ascend<level>(ray, grid.shifts, walk);
  };
  while (at_index<Grid::kLevels>(walk.depth, step)) {}
  counts.cells += cells;
  counts.macrocells += macrocells;
  return active;
}

}  // namespace isocast::inline ISO_ISA
