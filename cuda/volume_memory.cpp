#include <isocast/cuda/volume_memory.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/sparse_ranges.h>
#include <isocast/volume/sparse_tree.h>
#include <isocast/volume/volume.h>

#include <algorithm>
#include <cstring>

namespace isocast {
namespace {

std::size_t count_of(const std::int32_t (&dims)[3]) {
  return std::size_t(dims[0]) * std::size_t(dims[1]) * std::size_t(dims[2]);
}
// Bytes of a {min, max} pair of samples.
std::size_t range_bytes(SampleType type) {
  return visit_sample_type(
      type, []<class S>(SampleTag<S>) { return 2 * sizeof(typename SampleTraits<S>::Arithmetic); });
}
std::size_t range_bytes(SparseType type) {
  return visit_sparse_type(type, []<class S>(SparseTag<S>) {
    return 2 * sizeof(typename SampleTraits<typename SparseSample<S>::Type>::Arithmetic);
  });
}

}  // namespace

VolumeMemory::VolumeMemory(const Engine& engine, const VolumeQuery& query, const VolumeParts& parts)
    : engine_(engine), queue_(engine.make_queue()) {
  if (query.sparse) copy_tree(query, parts);
  else copy_grid(query);
  queue_->wait();
}

const void* VolumeMemory::copied(const void* from, std::size_t bytes) {
  if (bytes == 0) return nullptr;
  pieces_.push_back(engine_.allocate(bytes));
  queue_->upload(pieces_.back()->data(), from, bytes);
  return pieces_.back()->data();
}

void VolumeMemory::copy_grid(const VolumeQuery& query) {
  grid_ = query.grid;
  grid_.samples = copied(query.grid.samples, count_of(query.grid.dims) * size_of(query.grid.type));
  for (MacroLevel& level : grid_.levels)
    level.ranges = copied(level.ranges, count_of(level.dims) * range_bytes(query.grid.type));
}

// Samples and masks of leaves lie wherever their file put them: one after the other here.
void VolumeMemory::copy_tree(const VolumeQuery& query, const VolumeParts& parts) {
  const SparseTree& tree = *parts.volume.tree;
  const SparseView& from = query.tree;
  tree_ = from;
  if (!parts.ranges) return;  // nothing is active: no ray comes here
  std::vector<SparseLeaf> leaves(tree.leaves().begin(), tree.leaves().end());
  constexpr std::size_t kMaskBytes = kLeafSamples / 8;
  std::size_t bytes = 0;
  for (const SparseLeaf& leaf : leaves) bytes += leaf_bytes(from.type, leaf.code_bits) + kMaskBytes;
  std::vector<std::byte> samples(bytes);
  pieces_.push_back(engine_.allocate(std::max<std::size_t>(bytes, 1)));
  const auto* const there = static_cast<const std::byte*>(pieces_.back()->data());
  std::size_t at = 0;
  const auto pack = [&](const std::byte*& data, std::size_t size) {
    std::memcpy(samples.data() + at, data, size);
    data = there + at;
    at += size;
  };
  for (SparseLeaf& leaf : leaves) {
    pack(leaf.values, leaf_bytes(from.type, leaf.code_bits));
    pack(leaf.active, kMaskBytes);
  }
  queue_->upload(pieces_.back()->data(), samples.data(), bytes);
  tree_.leaves = static_cast<const SparseLeaf*>(copied(leaves.data(), leaves.size() * sizeof(SparseLeaf)));
  const std::size_t slots = std::size_t(from.root_mask) + 1, upper = tree.upper_count(),
                    lower = tree.lower_count();
  tree_.root = static_cast<const SparseRootSlot*>(copied(from.root, slots * sizeof(SparseRootSlot)));
  tree_.upper =
      static_cast<const SparseEntry*>(copied(from.upper, upper * kUpperEntries * sizeof(SparseEntry)));
  tree_.lower =
      static_cast<const SparseEntry*>(copied(from.lower, lower * kLowerEntries * sizeof(SparseEntry)));
  tree_.tiles = static_cast<const SparseTile*>(copied(from.tiles, tree.tile_count() * sizeof(SparseTile)));
  const std::size_t blocks[kTreeLevels] = {upper, lower, leaves.size()};
  for (int l = 0; l < kTreeLevels; ++l)
    ranges_.of[l] = copied(query.tree_ranges.of[l], blocks[l] * range_bytes(from.type));
  ranges_.near = static_cast<const std::uint64_t*>(
      copied(query.tree_ranges.near, lower * kLowerEntries / 64 * sizeof(std::uint64_t)));
  ranges_.beyond = static_cast<const SparseEntry(*)[7]>(
      copied(query.tree_ranges.beyond, leaves.size() * sizeof(SparseEntry[7])));
  queue_->wait();  // before what was copied goes
}

VolumeQuery VolumeMemory::translated(VolumeQuery query) const {
  query.grid = grid_;
  query.tree = tree_;
  query.tree_ranges = ranges_;
  query.cells = nullptr;
  return query;
}

std::size_t VolumeMemory::bytes() const {
  std::size_t bytes = 0;
  for (const auto& piece : pieces_) bytes += piece->bytes();
  return bytes;
}

}  // namespace isocast
