// A sparse grid in the type of its samples, as the walk sees it: walked in its own tree.
#pragma once

#include <isocast/math/real.h>
#include <isocast/volume/query.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/sparse_view.h>

namespace isocast::inline ISO_ISA {

/// The questions of DenseGrid, asked of a tree. A cell exists if its eight corners are finite and at least
/// one is active; inactive corners have the tree's value (background, tile or leaf), tiles count as samples.
template <class S> class SparseGrid {
 public:
  using Sample = typename SparseSample<S>::Type;
  using Key = typename SampleTraits<Sample>::Key;
  static constexpr int kLevels = kTreeLevels + 1;
  std::int32_t shifts[kLevels];

  /// The block of 8^3 cells a lane is in, and its entry.
  struct Place {
    std::int32_t block[3] = {kNowhere, 0, 0};
    SparseEntry entry;
  };

  ISO_HD explicit SparseGrid(const VolumeQuery& query)
      : tree_(query.tree), ranges_(query.tree_ranges), iso_count_(query.iso_count) {
    for (int i = 0; i < iso_count_; ++i) keys_[i] = Key(query.key[i]);
    for (int l = 0; l < kLevels; ++l) shifts[l] = tree_shift(l);
  }

  ISO_HD Sample at(const std::int32_t (&c)[3]) const { return sample_at<S>(tree_, c); }

  /// Nothing: the way to the samples would be the longer part.
  void prefetch(const std::int32_t (&)[3]) const {}

  ISO_HD void load_corners(const std::int32_t (&c)[3], const Place& place, Sample (&f)[8]) const {
    const int n = leaf_index(c[0], c[1], c[2]);
    if (place.entry.is_child() && inside_leaf(c)) {
      const SparseLeaf& leaf = tree_.leaves[place.entry.index()];
      for (int k = 0; k < 8; ++k) f[k] = SparseSample<S>::of_leaf(leaf, n + offset(k));
      return;
    }
    for (int k = 0; k < 8; ++k) {
      const Corner corner = find_corner(c, place, k);
      f[k] = corner.entry.is_child()
                 ? SparseSample<S>::of_leaf(tree_.leaves[corner.entry.index()], corner.index)
                 : tile_value<S>(tree_.tiles[corner.entry.index()]);
    }
  }

  /// Makes `place` that of cell c.
  ISO_HD void enter(const std::int32_t (&c)[3], Place& place) const {
    const std::int32_t block[3] = {c[0] >> 3, c[1] >> 3, c[2] >> 3};
    if (place.block[0] != block[0] || place.block[1] != block[1] || place.block[2] != block[2])
      set_place(place, block, find_entry(tree_, kTreeLevels - 1, block).entry);
  }

  ISO_HD std::uint32_t active_isos(const std::int32_t (&c)[3], Place& place) const {
    enter(c, place);
    Sample raw[8];
    load_corners(c, place, raw);
    const std::uint32_t parted = parted_isos(raw, keys_, iso_count_);
    return parted && any_active(c, place) ? parted : 0;
  }

  ISO_HD bool block_active(int level, const std::int32_t (&b)[3], Place& place) const {
    const FoundEntry own = find_entry(tree_, level, b);
    if (own.level == kTreeLevels - 1 && !(ranges_.near[own.place >> 6] >> (own.place & 63) & 1)) return false;
    if (level == kTreeLevels - 1) set_place(place, b, own.entry);
    Range range = range_of(level, own.entry);
    if (!own.entry.is_child()) {
      // one value within the tile; blocks at its far faces see what lies beyond
      const std::int32_t last = (1 << (tree_shift(own.level) - tree_shift(level))) - 1;
      int faces = 0;
      for (int a = 0; a < 3; ++a) faces |= int((b[a] & last) == last) << a;
      for (int k = 1; k < 8; ++k) {
        if (!(k & faces)) continue;
        const std::int32_t beyond[3] = {b[0] + (k & 1), b[1] + (k >> 1 & 1), b[2] + (k >> 2)};
        const Range other = range_of(level, find_entry(tree_, level, beyond).entry);
        const bool number = other.lo == other.lo;
        range.lo = number && !(range.lo <= other.lo) ? other.lo : range.lo;
        range.hi = number && !(range.hi >= other.hi) ? other.hi : range.hi;
      }
    }
    return parts_range(range.lo, range.hi, keys_, iso_count_);
  }

 private:
  using Arithmetic = typename SampleTraits<Sample>::Arithmetic;
  static constexpr std::int32_t kNowhere = 0x7fffffff;
  struct Range {
    Arithmetic lo, hi;
  };
  struct Corner {
    SparseEntry entry;
    int index;
  };

  static ISO_HD void set_place(Place& place, const std::int32_t (&block)[3], SparseEntry entry) {
    for (int a = 0; a < 3; ++a) place.block[a] = block[a];
    place.entry = entry;
  }
  static ISO_HD bool inside_leaf(const std::int32_t (&c)[3]) {
    return (c[0] & 7) < 7 && (c[1] & 7) < 7 && (c[2] & 7) < 7;
  }
  // From a leaf's sample to the corner in direction k.
  static ISO_HD int offset(int k) { return (k & 1) << 6 | (k >> 1 & 1) << 3 | k >> 2; }

  // Corner k of cell c: its block's entry and its number there. Corners beyond the far faces of a leaf are
  // found through its `beyond`, those of a tile through the tree.
  ISO_HD Corner find_corner(const std::int32_t (&c)[3], const Place& place, int k) const {
    const std::int32_t p[3] = {c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)};
    const int index = leaf_index(p[0], p[1], p[2]), side = int((p[0] >> 3) != place.block[0]) |
                                                           int((p[1] >> 3) != place.block[1]) << 1 |
                                                           int((p[2] >> 3) != place.block[2]) << 2;
    if (side == 0) return {place.entry, index};
    if (place.entry.is_child()) return {ranges_.beyond[place.entry.index()][side - 1], index};
    const std::int32_t block[3] = {p[0] >> 3, p[1] >> 3, p[2] >> 3};
    return {find_entry(tree_, kTreeLevels - 1, block).entry, index};
  }

  ISO_HD bool any_active(const std::int32_t (&c)[3], const Place& place) const {
    bool any = false;
    for (int k = 0; k < 8 && !any; ++k) {
      const Corner corner = find_corner(c, place, k);
      any = corner.entry.is_child() ? leaf_active(tree_.leaves[corner.entry.index()], corner.index)
                                    : tree_.tiles[corner.entry.index()].active != 0;
    }
    return any;
  }

  // Of a child, with what lies beyond its far faces; of a tile, its value, which may be NaN.
  ISO_HD Range range_of(int level, SparseEntry entry) const {
    if (entry.is_child()) return static_cast<const Range*>(ranges_.of[level])[entry.index()];
    const Arithmetic value = number(tile_value<S>(tree_.tiles[entry.index()]));
    return {value, value};
  }

  SparseView tree_;
  SparseRanges ranges_;
  Key keys_[kMaxIsos];
  int iso_count_;
};

}  // namespace isocast::inline ISO_ISA
