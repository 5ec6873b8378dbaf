// A grid of samples in the type of the file, as the walk sees it.
#pragma once

#include <isocast/volume/query.h>
#include <isocast/volume/sample.h>

namespace isocast::inline ISO_ISA {

/// What the walk asks of a grid; SparseGrid (sparse_grid.h) answers the same questions.
///
/// Sample   type of the corners that load_corners gives
/// kLevels  levels of the walk, single cells last; `shifts` is log2 of each level's blocks in cells
/// Place    what a lane keeps of its current block for the cells in it: here, nothing
template <class S> class DenseGrid {
 public:
  using Sample = S;
  using Key = typename SampleTraits<S>::Key;
  static constexpr int kLevels = kMacroLevels + 1;
  struct Place {};
  std::int32_t shifts[kLevels] = {};

  ISO_HD explicit DenseGrid(const VolumeQuery& query) : grid_(query.grid), iso_count_(query.iso_count) {
    for (int i = 0; i < iso_count_; ++i) keys_[i] = Key(query.key[i]);
    for (int l = 0; l < kMacroLevels; ++l) shifts[l] = grid_.levels[l].shift;
  }

  /// The sample of grid point c, inside the grid.
  ISO_HD S at(const std::int32_t (&c)[3]) const { return *corner(c); }

  /// Makes `place` that of cell c.
  ISO_HD void enter(const std::int32_t (&)[3], Place&) const {}

  /// Asks memory for the corners of cell c.
  void prefetch(const std::int32_t (&c)[3]) const {
    const S* p = corner(c);
    const std::size_t row = std::size_t(grid_.dims[0]), slice = row * std::size_t(grid_.dims[1]);
    for (const std::size_t offset : {std::size_t(0), row, slice, slice + row}) __builtin_prefetch(p + offset);
  }

  /// The eight corners of cell c, x fastest.
  ISO_HD void load_corners(const std::int32_t (&c)[3], const Place&, S (&f)[8]) const {
    const S* p = corner(c);
    const std::size_t row = std::size_t(grid_.dims[0]), slice = row * std::size_t(grid_.dims[1]);
    f[0] = p[0];
    f[1] = p[1];
    f[2] = p[row];
    f[3] = p[row + 1];
    f[4] = p[slice];
    f[5] = p[slice + 1];
    f[6] = p[slice + row];
    f[7] = p[slice + row + 1];
  }

  /// Bit i set: some corners lie below iso i and some do not. NaN corners may set it wrongly; fetching drops
  /// such cells.
  ISO_HD std::uint32_t active_isos(const std::int32_t (&c)[3], Place& place) const {
    S raw[8];
    load_corners(c, place, raw);
    return parted_isos(raw, keys_, iso_count_);
  }

  /// Whether block b of a level may hold an active cell.
  ISO_HD bool block_active(int level, const std::int32_t (&b)[3], Place&) const {
    const MacroLevel& blocks = grid_.levels[level];
    const std::size_t index =
        (std::size_t(b[2]) * std::size_t(blocks.dims[1]) + std::size_t(b[1])) * std::size_t(blocks.dims[0]) +
        std::size_t(b[0]);
    using Range = typename SampleTraits<S>::Arithmetic;
    const Range* range = static_cast<const Range*>(blocks.ranges) + 2 * index;
    return parts_range(range[0], range[1], keys_, iso_count_);
  }

 private:
  // Lowest corner of a cell; the others lie at {0,1} + {0, row} + {0, slice}.
  ISO_HD const S* corner(const std::int32_t (&c)[3]) const {
    return static_cast<const S*>(grid_.samples) +
           (std::size_t(c[2]) * std::size_t(grid_.dims[1]) + std::size_t(c[1])) * std::size_t(grid_.dims[0]) +
           std::size_t(c[0]);
  }

  GridView grid_;
  Key keys_[kMaxIsos];
  int iso_count_;
};

}  // namespace isocast::inline ISO_ISA
