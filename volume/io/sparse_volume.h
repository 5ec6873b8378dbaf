// From the parts of a sparse grid to a volume.
#pragma once

#include <isocast/volume/volume.h>

namespace isocast {

/// Gives the volume its tree, and dims by the active samples. Throws SparseTreeError.
void set_tree(Volume& volume, SparseType type, std::uint64_t background, std::span<const SparseLeaf> leaves,
              std::span<const TileBlock> tiles, std::shared_ptr<const void> storage);

}  // namespace isocast
