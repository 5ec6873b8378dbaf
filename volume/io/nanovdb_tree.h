// A NanoVDB grid in memory to the parts of a sparse tree.
#pragma once

#include <isocast/volume/volume.h>

namespace isocast {

/// Gives `volume` the tree, placement, name and class of a grid whose bytes lie in `storage` (of any
/// alignment). Every offset and count is checked against the grid's bytes, and every node may be met once
/// only.
///
/// throws  SparseTreeError with what was found and expected
void set_nanovdb_tree(Volume& volume, std::span<const std::byte> grid, std::shared_ptr<const void> storage);

}  // namespace isocast
