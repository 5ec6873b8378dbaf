#include <isocast/volume/io/sparse_volume.h>

#include <algorithm>

namespace isocast {

void set_tree(Volume& volume, SparseType type, std::uint64_t background, std::span<const SparseLeaf> leaves,
              std::span<const TileBlock> tiles, std::shared_ptr<const void> storage) {
  const auto tree = std::make_shared<SparseTree>(type, background, leaves, tiles, std::move(storage));
  for (std::size_t a = 0; a < 3; ++a)
    volume.dims[a] =
        std::max<std::int64_t>(0, std::int64_t(tree->last_active()[a]) - tree->first_active()[a] + 1);
  volume.tree = tree;
}

}  // namespace isocast
