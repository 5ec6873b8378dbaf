#include <isocast/volume/sample.h>
#include <isocast/volume/sparse_ranges.h>
#include <oneapi/tbb/parallel_for.h>

#include <limits>

namespace isocast {
namespace {

template <class S> using Number = typename SampleTraits<typename SparseSample<S>::Type>::Arithmetic;

// Empty until something is added; NaN adds nothing.
template <class A> struct Range {
  A lo = std::numeric_limits<A>::has_infinity ? std::numeric_limits<A>::infinity()
                                              : std::numeric_limits<A>::max();
  A hi = std::numeric_limits<A>::has_infinity ? -std::numeric_limits<A>::infinity()
                                              : std::numeric_limits<A>::lowest();
  void add(A v) {
    lo = v < lo ? v : lo;
    hi = v > hi ? v : hi;
  }
  void add(const Range& other) {
    lo = other.lo < lo ? other.lo : lo;
    hi = other.hi > hi ? other.hi : hi;
  }
};

using Point = std::array<std::int32_t, 3>;
Point neighbour(const Point& b, int k) { return {b[0] + (k & 1), b[1] + (k >> 1 & 1), b[2] + (k >> 2)}; }
SparseEntry entry_at(const SparseView& tree, int level, const Point& b) {
  return find_entry(tree, level, {b[0], b[1], b[2]}).entry;
}

template <class S> Range<Number<S>> tile_range(const SparseView& tree, SparseEntry entry) {
  Range<Number<S>> range;
  range.add(number(tile_value<S>(tree.tiles[entry.index()])));
  return range;
}

// The samples of an entry's block whose coordinate is 0 on every axis of `side`.
template <class S>
void add_near_side(const SparseView& tree, SparseEntry entry, int side, Range<Number<S>>& range) {
  if (!entry.is_child()) return range.add(tile_range<S>(tree, entry));
  const SparseLeaf& leaf = tree.leaves[entry.index()];
  for (int x = 0; x < (side & 1 ? 1 : 8); ++x)
    for (int y = 0; y < (side & 2 ? 1 : 8); ++y)
      for (int z = 0; z < (side & 4 ? 1 : 8); ++z)
        range.add(number(SparseSample<S>::of_leaf(leaf, leaf_index(x, y, z))));
}

template <class S>
void scan_leaf(const SparseView& tree, std::size_t i, std::array<SparseEntry, 7>& beyond,
               Range<Number<S>>& range) {
  const SparseLeaf& leaf = tree.leaves[i];
  const Point block = {leaf.origin[0] >> 3, leaf.origin[1] >> 3, leaf.origin[2] >> 3};
  for (int n = 0; n < kLeafSamples; ++n) range.add(number(SparseSample<S>::of_leaf(leaf, n)));
  for (int k = 1; k < 8; ++k) {
    beyond[k - 1] = entry_at(tree, 2, neighbour(block, k));
    add_near_side<S>(tree, beyond[k - 1], k, range);
  }
}

// The union over a block's entries, children by their own ranges.
template <class S>
Range<Number<S>> gather(const SparseView& tree, const SparseEntry* entries, std::size_t count,
                        const Range<Number<S>>* children) {
  Range<Number<S>> range;
  std::uint32_t last = ~0u;
  for (std::size_t n = 0; n < count; ++n) {
    if (entries[n].bits == last) continue;  // long rows of one tile
    last = entries[n].bits;
    range.add(entries[n].is_child() ? children[entries[n].index()] : tile_range<S>(tree, entries[n]));
  }
  return range;
}

// Adds to the range of each block of a level what lies beyond its far faces. `block_of(i)` is its place.
template <class S, class BlockOf>
void widen(const SparseView& tree, int level, std::vector<Range<Number<S>>>& ranges,
           const BlockOf& block_of) {
  const std::vector<Range<Number<S>>> own = ranges;
  oneapi::tbb::parallel_for(std::size_t(0), ranges.size(), [&](std::size_t i) {
    for (int k = 1; k < 8; ++k) {
      const SparseEntry entry = entry_at(tree, level, neighbour(block_of[i], k));
      ranges[i].add(entry.is_child() ? own[entry.index()] : tile_range<S>(tree, entry));
    }
  });
}

// Marks entry n of a lower block and those whose far sides it lies beyond, in this block or the ones before.
class NearMarks {
 public:
  NearMarks(const SparseView& tree, std::vector<std::uint64_t>& marks) : tree_(tree), marks_(marks) {}

  void mark_around(const Point& leaf_block) {
    for (int k = 0; k < 8; ++k)
      mark({leaf_block[0] - (k & 1), leaf_block[1] - (k >> 1 & 1), leaf_block[2] - (k >> 2)});
  }
  void mark(const Point& leaf_block) {
    const FoundEntry found = find_entry(tree_, 2, {leaf_block[0], leaf_block[1], leaf_block[2]});
    if (found.level == 2) marks_[found.place >> 6] |= std::uint64_t(1) << (found.place & 63);
  }

 private:
  const SparseView& tree_;
  std::vector<std::uint64_t>& marks_;
};

// Entries that are not background, and the far sides that meet a tile of a coarser level.
void mark_near(const SparseView& tree, const std::vector<Point>& lower_blocks,
               std::vector<std::uint64_t>& marks) {
  NearMarks near(tree, marks);
  for (std::size_t i = 0; i < lower_blocks.size(); ++i) {
    const Point first = {lower_blocks[i][0] * 16, lower_blocks[i][1] * 16, lower_blocks[i][2] * 16};
    for (std::int32_t n = 0; n < std::int32_t(kLowerEntries); ++n)
      if (tree.lower[i * kLowerEntries + std::size_t(n)].bits != 0)
        near.mark_around({first[0] + (n >> 8), first[1] + (n >> 4 & 15), first[2] + (n & 15)});
    for (int k = 1; k < 8; ++k) {
      const SparseEntry beyond = entry_at(tree, 1, neighbour(lower_blocks[i], k));
      if (beyond.is_child() || beyond.bits == 0) continue;
      for (std::int32_t x = k & 1 ? 15 : 0; x < 16; ++x)
        for (std::int32_t y = k & 2 ? 15 : 0; y < 16; ++y)
          for (std::int32_t z = k & 4 ? 15 : 0; z < 16; ++z)
            near.mark({first[0] + x, first[1] + y, first[2] + z});
    }
  }
}

template <class A> std::vector<std::byte> bytes_of(const std::vector<Range<A>>& ranges) {
  const auto bytes = std::as_bytes(std::span(ranges));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

SparseRangeTree::SparseRangeTree(const SparseTree& sparse) : beyond_(sparse.leaves().size()) {
  const SparseView& tree = sparse.view();
  visit_sparse_type(sparse.type(), [&]<class S>(SparseTag<S>) {
    using R = Range<Number<S>>;
    std::vector<R> leaves(sparse.leaves().size()), lower(sparse.lower_count()), upper(sparse.upper_count());
    oneapi::tbb::parallel_for(std::size_t(0), leaves.size(),
                              [&](std::size_t i) { scan_leaf<S>(tree, i, beyond_[i], leaves[i]); });

    // where the blocks stand
    std::vector<Point> upper_blocks(upper.size()), lower_blocks(lower.size());
    for (const SparseRootSlot& slot : sparse.root())
      if (slot.used && slot.entry.is_child())
        upper_blocks[slot.entry.index()] = {slot.block[0], slot.block[1], slot.block[2]};
    for (std::size_t u = 0; u < upper.size(); ++u)
      for (std::int32_t n = 0; n < std::int32_t(kUpperEntries); ++n)
        if (const SparseEntry entry = tree.upper[u * kUpperEntries + std::size_t(n)]; entry.is_child())
          lower_blocks[entry.index()] = {upper_blocks[u][0] * 32 + (n >> 10),
                                         upper_blocks[u][1] * 32 + (n >> 5 & 31),
                                         upper_blocks[u][2] * 32 + (n & 31)};

    near_.resize(lower.size() * kLowerEntries / 64);
    mark_near(tree, lower_blocks, near_);
    oneapi::tbb::parallel_for(std::size_t(0), lower.size(), [&](std::size_t i) {
      lower[i] = gather<S>(tree, tree.lower + i * kLowerEntries, kLowerEntries, leaves.data());
    });
    widen<S>(tree, 1, lower, lower_blocks);
    oneapi::tbb::parallel_for(std::size_t(0), upper.size(), [&](std::size_t i) {
      upper[i] = gather<S>(tree, tree.upper + i * kUpperEntries, kUpperEntries, lower.data());
    });
    widen<S>(tree, 0, upper, upper_blocks);
    ranges_[0] = bytes_of(upper);
    ranges_[1] = bytes_of(lower);
    ranges_[2] = bytes_of(leaves);
  });
}

SparseRanges SparseRangeTree::view() const {
  static_assert(sizeof(std::array<SparseEntry, 7>) == sizeof(SparseEntry[7]));
  return {{ranges_[0].data(), ranges_[1].data(), ranges_[2].data()},
          near_.data(),
          reinterpret_cast<const SparseEntry(*)[7]>(beyond_.data())};
}

std::size_t SparseRangeTree::bytes() const {
  std::size_t bytes = beyond_.size() * sizeof beyond_[0] + near_.size() * sizeof near_[0];
  for (const auto& ranges : ranges_) bytes += ranges.size();
  return bytes;
}

}  // namespace isocast
