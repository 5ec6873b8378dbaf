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
  for (;;) {
    bool found = false;
    if (walk.depth == walk.kCells) {
      found = walk_level(ray, walk, tested, [&](const std::int32_t(&c)[3]) {
        ++cells;
        active = grid.active_isos(c, place);
        return active != 0;
      });
      if (found) break;
    } else {
      const int level = walk.depth;
      found = walk_level(ray, walk, tested, [&](const std::int32_t(&b)[3]) {
        ++macrocells;
        return grid.block_active(level, b, place);
      });
    }
    tested = false;
    if (found) descend(ray, grid.shifts[walk.depth], grid.shifts[walk.depth + 1], walk);
    else if (!ascend(ray, walk)) break;
  }
  counts.cells += cells;
  counts.macrocells += macrocells;
  return active;
}

}  // namespace isocast::inline ISO_ISA
