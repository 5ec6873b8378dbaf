// The bricks of 16^3 cells that the active cells of a grid may be in, whatever the iso-value.
#pragma once

#include <isocast/volume/grid.h>
#include <isocast/volume/sparse_tree.h>

#include <array>
#include <cstddef>
#include <vector>

namespace isocast {

/// dense   all of the grid's, numbered with x fastest; `first` is empty
/// sparse  those that hold cells with an active corner, but for the inside of tiles, in any order: `first` is
///         the first cell of each, a multiple of 16
struct Bricks {
  std::size_t count = 0;
  std::vector<std::array<std::int32_t, 3>> first;
};

[[nodiscard]] Bricks dense_bricks(const GridView& grid);
/// None at all where large active tiles have too many.
[[nodiscard]] Bricks sparse_bricks(const SparseTree& tree);

}  // namespace isocast
