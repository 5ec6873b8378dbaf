// From one active cell to the next: the walk, the macrocells that let it leap, and the test of a cell's eight
// corners.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/query.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

/// The volume in the type of its samples.
template <class S> struct TypedGrid {
  using Arithmetic = typename SampleTraits<S>::Arithmetic;
  using Key = typename SampleTraits<S>::Key;
  const GridView& grid;
  Key keys[kMaxIsos];
  int iso_count;

  ISO_HD explicit TypedGrid(const VolumeQuery& query) : grid(query.grid), iso_count(query.iso_count) {
    for (int i = 0; i < iso_count; ++i) keys[i] = Key(query.key[i]);
  }

  /// Lowest corner of a cell; the others lie at {0,1} + {0, row} + {0, slice}.
  ISO_HD const S* corner(const std::int32_t (&c)[3]) const {
    return static_cast<const S*>(grid.samples) +
           (std::size_t(c[2]) * std::size_t(grid.dims[1]) + std::size_t(c[1])) * std::size_t(grid.dims[0]) +
           std::size_t(c[0]);
  }
  ISO_HD void load_corners(const std::int32_t (&c)[3], S (&f)[8]) const {
    const S* p = corner(c);
    const std::size_t row = std::size_t(grid.dims[0]), slice = row * std::size_t(grid.dims[1]);
    f[0] = p[0];
    f[1] = p[1];
    f[2] = p[row];
    f[3] = p[row + 1];
    f[4] = p[slice];
    f[5] = p[slice + 1];
    f[6] = p[slice + row];
    f[7] = p[slice + row + 1];
  }

  /// Bit i set: some corners lie below iso i and some do not. NaN corners may set it wrongly; fetching drops
  /// such cells.
  ISO_HD std::uint32_t active_isos(const std::int32_t (&c)[3]) const {
    S raw[8];
    load_corners(c, raw);
    std::uint32_t active = 0;
    for (int i = 0; i < iso_count; ++i) {
      int below = 0;
      for (int k = 0; k < 8; ++k) below += number(raw[k]) < keys[i];
      active |= std::uint32_t(below > 0 && below < 8) << i;
    }
    return active;
  }

  /// Whether a block may hold an active cell.
  ISO_HD bool block_active(const MacroLevel& level, const std::int32_t (&b)[3]) const {
    const std::size_t index =
        (std::size_t(b[2]) * std::size_t(level.dims[1]) + std::size_t(b[1])) * std::size_t(level.dims[0]) +
        std::size_t(b[0]);
    const Arithmetic* range = static_cast<const Arithmetic*>(level.ranges) + 2 * index;
    bool active = false;
    for (int i = 0; i < iso_count; ++i) active = active | (range[0] < keys[i] && !(range[1] < keys[i]));
    return active;
  }
};

/// Shifts of the walk's levels, cells last.
struct Shifts {
  std::int32_t of[kWalkLevels];
  ISO_HD explicit Shifts(const GridView& grid) {
    for (int l = 0; l < kMacroLevels; ++l) of[l] = grid.levels[l].shift;
    of[kCells] = 0;
  }
};

/// Walks on to a cell whose corners enclose an iso-value and returns their bits, or 0 at the end of the ray.
/// `tested`: the current cell is done with.
template <class S>
ISO_HD inline std::uint32_t march(const TypedGrid<S>& grid, const Shifts& shifts, const GridRay& ray,
                                  GridWalk& walk, bool tested, TraceCounts& counts) {
  std::uint32_t active = 0;
  std::int64_t cells = 0, macrocells = 0;
  for (;;) {
    bool found = false;
    if (walk.depth == kCells) {
      found = walk_level(ray, walk, tested, [&](const std::int32_t(&c)[3]) {
        ++cells;
        active = grid.active_isos(c);
        return active != 0;
      });
      if (found) break;
    } else {
      const MacroLevel& blocks = grid.grid.levels[walk.depth];
      found = walk_level(ray, walk, tested, [&](const std::int32_t(&b)[3]) {
        ++macrocells;
        return grid.block_active(blocks, b);
      });
    }
    tested = false;
    if (found) descend(ray, shifts.of[walk.depth], shifts.of[walk.depth + 1], walk);
    else if (!ascend(ray, walk)) break;
  }
  counts.cells += cells;
  counts.macrocells += macrocells;
  return active;
}

}  // namespace isocast::inline ISO_ISA
