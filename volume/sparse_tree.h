// A sparse grid as it was read: which blocks have samples of their own, which one value throughout.
#pragma once

#include <isocast/volume/sparse_view.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace isocast {

/// A block of one value. `edge` is its edge as log2: one of kTreeShifts but the last (12, 7, 3).
struct TileBlock {
  std::array<std::int32_t, 3> origin;
  std::int32_t edge;
  SparseTile tile;
};

/// Why parts make no tree.
struct SparseTreeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Grid points |x| up to this.
inline constexpr std::int32_t kMaxGridPoint = 1 << 30;

/// The tree of OpenVDB's standard shape (5, 4, 3: blocks of 4096^3, 128^3 and 8^3 samples) over leaves whose
/// samples lie elsewhere, in `storage`, which the tree keeps alive. Grid space is the file's index space.
class SparseTree {
 public:
  /// background  bits of the value outside, as in SparseTile
  /// throws      SparseTreeError for origins that are no multiple of their block's edge or lie beyond
  ///             kMaxGridPoint, two parts in one place, more than 2^31 parts
  SparseTree(SparseType type, std::uint64_t background, std::span<const SparseLeaf> leaves,
             std::span<const TileBlock> tiles, std::shared_ptr<const void> storage);

  [[nodiscard]] const SparseView& view() const { return view_; }
  [[nodiscard]] SparseType type() const { return view_.type; }
  [[nodiscard]] std::span<const SparseLeaf> leaves() const { return leaves_; }
  [[nodiscard]] std::span<const TileBlock> active_tiles() const { return active_tiles_; }
  [[nodiscard]] std::span<const SparseRootSlot> root() const { return root_; }
  [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
  [[nodiscard]] std::size_t upper_count() const { return upper_count_; }
  [[nodiscard]] std::size_t lower_count() const { return lower_count_; }

  /// First and last active grid point per axis, tiles included; first > last where nothing is active.
  [[nodiscard]] const std::array<std::int32_t, 3>& first_active() const { return first_; }
  [[nodiscard]] const std::array<std::int32_t, 3>& last_active() const { return last_; }
  /// Active samples, those of tiles included; as a double, for tiles can hold more than 2^63.
  [[nodiscard]] double active_count() const { return active_count_; }
  /// Bytes of the leaves' samples and masks, and of the tree above.
  [[nodiscard]] std::size_t bytes() const;

 private:
  SparseEntry& root_entry(const std::int32_t (&block)[3]);
  void add_bounds(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last);
  void count_active(const SparseLeaf& leaf);

  struct FreeEntries {
    void operator()(SparseEntry* entries) const;
  };
  using Entries = std::unique_ptr<SparseEntry[], FreeEntries>;
  static Entries zeroed(std::size_t count);

  std::shared_ptr<const void> storage_;
  std::vector<SparseLeaf> leaves_;
  std::vector<SparseTile> tiles_;
  std::vector<TileBlock> active_tiles_;
  std::vector<SparseRootSlot> root_;
  Entries upper_, lower_;
  std::size_t upper_count_ = 0, lower_count_ = 0;
  std::array<std::int32_t, 3> first_, last_;
  double active_count_ = 0;
  SparseView view_ = {};
};

/// "f32" ... "i64", "fp4" ... "fpn".
[[nodiscard]] std::string_view name_of(SparseType type);
/// Bytes that a leaf's samples take, with minimum and quantum for codes.
[[nodiscard]] std::size_t leaf_bytes(SparseType type, int code_bits);

}  // namespace isocast
