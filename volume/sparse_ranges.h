// The ranges that let the walk leap over blocks of a sparse grid, whatever the iso-value.
#pragma once

#include <isocast/volume/sparse_tree.h>

#include <array>
#include <memory>
#include <vector>

namespace isocast {

/// Ranges of a tree's leaves and of the blocks above. A leaf's is exact: over the 9^3 samples of the cells
/// that start in it; a block's holds those of its children, tiles and of the blocks beyond its far faces.
/// Built once, in parallel; serves every iso-value.
class SparseRangeTree {
 public:
  /// Keeps no reference to the tree.
  explicit SparseRangeTree(const SparseTree& tree);

  [[nodiscard]] SparseRanges view() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::vector<std::byte> ranges_[kTreeLevels];
  std::vector<std::uint64_t> near_;
  std::vector<std::array<SparseEntry, 7>> beyond_;
};

}  // namespace isocast
