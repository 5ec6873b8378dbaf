// A sparse grid as kernels see it: a tree of blocks in flat arrays, shaped like OpenVDB's standard tree.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast {

/// Types of the samples: numbers, or codes of 4, 8, 16 or (per leaf) 1 to 16 bits that stand for floats
/// (NanoVDB's Fp4, Fp8, Fp16, FpN).
enum class SparseType : std::uint8_t { f32, f64, i16, i32, i64, fp4, fp8, fp16, fpn };

/// Levels of the tree as log2 of their blocks' edges in samples: the root holds upper blocks, these hold 32^3
/// lower blocks, these hold 16^3 leaves of 8^3 samples. Then the samples.
inline constexpr int kTreeLevels = 3;
inline constexpr std::int32_t kTreeShifts[kTreeLevels + 1] = {12, 7, 3, 0};
/// kTreeShifts[level], where an array cannot be reached.
ISO_HD constexpr std::int32_t tree_shift(int level) {
  return level == 0 ? 12 : level == 1 ? 7 : level == 2 ? 3 : 0;
}
inline constexpr int kLeafSamples = 512;
inline constexpr std::size_t kUpperEntries = 32768, kLowerEntries = 4096;

/// What fills a place of the tree: the number of a child, or that of a tile (one value throughout). Zero is
/// tile 0: the background.
struct SparseEntry {
  std::uint32_t bits = 0;
  static constexpr std::uint32_t kChild = 0x80000000u;

  ISO_HD bool is_child() const { return bits & kChild; }
  ISO_HD std::uint32_t index() const { return bits & ~kChild; }
};

/// 8^3 samples, z fastest. They need no alignment.
///
/// values     512 numbers; for codes: minimum and quantum (float), 8 unused bytes, then the codes
/// active     512 bits, sample n is bit n % 8 of byte n / 8
/// origin     grid point of sample 0
/// code_bits  bits of a code (fpn)
struct SparseLeaf {
  const std::byte* values;
  const std::byte* active;
  std::int32_t origin[3];
  std::int32_t code_bits;
};

/// One value for a whole block: the bits of a number (of a float for codes).
struct SparseTile {
  std::uint64_t value;
  std::uint64_t active;
};

/// A slot of the root's hash table (open addressing); empty where `used` is 0.
struct SparseRootSlot {
  std::int32_t block[3];
  SparseEntry entry;
  std::uint32_t used;
};

/// The tree. `root_mask` is the size of its hash table less one; upper block i has entries
/// [i kUpperEntries, (i + 1) kUpperEntries), z fastest, lower blocks alike.
struct SparseView {
  const SparseRootSlot* root;
  std::uint32_t root_mask;
  SparseType type;
  const SparseEntry* upper;
  const SparseEntry* lower;
  const SparseLeaf* leaves;
  const SparseTile* tiles;
};

/// What the walk knows of the tree's blocks, whatever the iso-value: {min, max} pairs (numbers as in
/// SampleTraits<S>::Arithmetic) over all samples of the cells that start in a block, with those beyond its
/// far faces; NaN is left out. `near`: a bit for each entry of the lower blocks, 64 words a block; where it
/// is 0, that entry and all beyond its far sides are background. `beyond`: of each leaf, the entries at its
/// far faces, edges and corner, [i][k - 1] in direction k (bit 0: x, 1: y, 2: z).
struct SparseRanges {
  const void* of[kTreeLevels];
  const std::uint64_t* near;
  const SparseEntry (*beyond)[7];
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// Hash of a root block's coordinates.
ISO_HD inline std::uint32_t root_hash(const std::int32_t (&b)[3]) {
  const std::uint32_t h =
      std::uint32_t(b[0]) * 73856093u ^ std::uint32_t(b[1]) * 19349663u ^ std::uint32_t(b[2]) * 83492791u;
  return h ^ h >> 15;
}

/// What fills block b of a level; the level it stands on, that of b or a coarser one where a tile fills more
/// than the block; and its place among all entries of that level (not of the root's).
struct FoundEntry {
  SparseEntry entry;
  int level;
  std::size_t place;
};
ISO_HD_CALLED inline FoundEntry find_entry(const SparseView& tree, int level, const std::int32_t (&b)[3]) {
  const int to_root = tree_shift(0) - tree_shift(level);
  const std::int32_t root[3] = {b[0] >> to_root, b[1] >> to_root, b[2] >> to_root};
  SparseEntry entry;
  for (std::uint32_t slot = root_hash(root) & tree.root_mask; tree.root[slot].used;
       slot = (slot + 1) & tree.root_mask) {
    const SparseRootSlot& at = tree.root[slot];
    if (at.block[0] == root[0] && at.block[1] == root[1] && at.block[2] == root[2]) {
      entry = at.entry;
      break;
    }
  }
  if (level == 0 || !entry.is_child()) return {entry, 0, 0};
  const int s = tree_shift(1) - tree_shift(level);
  const std::size_t upper = entry.index() * kUpperEntries +
                            std::size_t((b[0] >> s & 31) << 10 | (b[1] >> s & 31) << 5 | (b[2] >> s & 31));
  entry = tree.upper[upper];
  if (level == 1 || !entry.is_child()) return {entry, 1, upper};
  const std::size_t lower =
      entry.index() * kLowerEntries + std::size_t((b[0] & 15) << 8 | (b[1] & 15) << 4 | (b[2] & 15));
  return {tree.lower[lower], 2, lower};
}

/// Number of a grid point's sample in its leaf.
ISO_HD inline int leaf_index(std::int32_t x, std::int32_t y, std::int32_t z) {
  return (x & 7) << 6 | (y & 7) << 3 | (z & 7);
}
ISO_HD inline bool leaf_active(const SparseLeaf& leaf, int n) {
  return std::uint32_t(leaf.active[n >> 3]) >> (n & 7) & 1;
}

/// Codes of B bits (0: SparseLeaf::code_bits) that stand for floats.
template <int B> struct Coded {};

/// The number that a type of samples gives, and how a leaf and a tile hold it.
template <class S> struct SparseSample {
  using Type = S;
  static ISO_HD S of_leaf(const SparseLeaf& leaf, int n) {
    S value;
    __builtin_memcpy(&value, leaf.values + std::size_t(n) * sizeof(S), sizeof(S));
    return value;
  }
};
template <int B> struct SparseSample<Coded<B>> {
  using Type = float;
  static ISO_HD float of_leaf(const SparseLeaf& leaf, int n) {
    float minimum, quantum;
    __builtin_memcpy(&minimum, leaf.values, 4);
    __builtin_memcpy(&quantum, leaf.values + 4, 4);
    const int bits = B ? B : leaf.code_bits, at = n * bits;
    const std::byte* codes = leaf.values + 16;
    const std::uint32_t code = bits == 16 ? std::uint32_t(codes[2 * n]) | std::uint32_t(codes[2 * n + 1]) << 8
                                          : std::uint32_t(codes[at >> 3]) >> (at & 7) & ((1u << bits) - 1);
    return float(code) * quantum + minimum;
  }
};
template <class S> ISO_HD inline typename SparseSample<S>::Type tile_value(const SparseTile& tile) {
  typename SparseSample<S>::Type value;
  __builtin_memcpy(&value, &tile.value, sizeof value);
  return value;
}

/// The sample of grid point c.
template <class S>
ISO_HD inline typename SparseSample<S>::Type sample_at(const SparseView& tree, const std::int32_t (&c)[3]) {
  const std::int32_t block[3] = {c[0] >> 3, c[1] >> 3, c[2] >> 3};
  const SparseEntry entry = find_entry(tree, kTreeLevels - 1, block).entry;
  if (!entry.is_child()) return tile_value<S>(tree.tiles[entry.index()]);
  return SparseSample<S>::of_leaf(tree.leaves[entry.index()], leaf_index(c[0], c[1], c[2]));
}

template <class S> struct SparseTag { using Type = S; };
/// Calls visit(SparseTag<S>{}) with S a number's type or Coded<B>.
template <class Visit> decltype(auto) visit_sparse_type(SparseType type, Visit&& visit) {
  switch (type) {
    case SparseType::f32: return visit(SparseTag<float>{});
    case SparseType::f64: return visit(SparseTag<double>{});
    case SparseType::i16: return visit(SparseTag<std::int16_t>{});
    case SparseType::i32: return visit(SparseTag<std::int32_t>{});
    case SparseType::i64: return visit(SparseTag<std::int64_t>{});
    case SparseType::fp4: return visit(SparseTag<Coded<4>>{});
    case SparseType::fp8: return visit(SparseTag<Coded<8>>{});
    case SparseType::fp16: return visit(SparseTag<Coded<16>>{});
    default: return visit(SparseTag<Coded<0>>{});
  }
}

}  // namespace isocast::inline ISO_ISA
