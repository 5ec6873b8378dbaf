#include <isocast/volume/bricks/make_mask.h>
#include <isocast/volume/visit_grid.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace isocast {
namespace {

// Bit i set: byte i of eight is 1; each byte is 0 or 1.
std::uint32_t bits_of_bytes(const std::uint8_t* bytes) {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t all;
  std::memcpy(&all, bytes, sizeof all);
  return static_cast<std::uint32_t>(all * 0x0102040810204080u >> 56);
}

// Bit i set: sample i of a row lies below the key. Whole rows are compared many at a time.
template <class S> std::uint32_t row_below(const S* row, int count, typename SampleTraits<S>::Key key) {
  std::uint32_t bits = 0;
  int i = 0;
  if (count > kBrickSize) {
    std::uint8_t below[kBrickSize];
    for (; i < kBrickSize; ++i) below[i] = number(row[i]) < key;
    bits = bits_of_bytes(below) | bits_of_bytes(below + 8) << 8;
  }
  for (; i < count; ++i) bits |= std::uint32_t(number(row[i]) < key) << i;
  return bits;
}

// Puts the active cells of row (y, z) of the brick into its blocks.
void add_row(std::uint32_t active, int y, int z, BrickMask& mask) {
  const int block = y / 4 * 4 + z / 4 * 16, shift = y % 4 * 4 + z % 4 * 16;
  for (int x = 0; x < 4; ++x) mask.cells[block + x] |= std::uint64_t(active >> 4 * x & 15) << shift;
}

constexpr int kStrips = 4;  // along each axis

// Where a brick's samples are, and how many cells it has along each axis.
template <class S> struct BrickRows {
  const S* corner;
  std::size_t row, slice;
  int cells[3];

  BrickRows(const GridView& grid, const std::int32_t (&first)[3]) {
    row = std::size_t(grid.dims[0]);
    slice = row * std::size_t(grid.dims[1]);
    corner = static_cast<const S*>(grid.samples) + std::size_t(first[2]) * slice +
             std::size_t(first[1]) * row + std::size_t(first[0]);
    for (int a = 0; a < 3; ++a) cells[a] = std::min(kBrickSize, grid.dims[a] - 1 - first[a]);
  }
  [[nodiscard]] const S* at(int y, int z) const {
    return corner + std::size_t(z) * slice + std::size_t(y) * row;
  }
};

// The strips of four blocks along x, number y + 4 z, of which the ranges say that some block may hold active
// cells.
template <class S>
std::uint32_t active_strips(const DenseGrid<S>& dense, const VolumeQuery& query,
                            const std::int32_t (&brick)[3]) {
  constexpr int kFine = kMacroLevels - 1;
  static_assert(kMacroLevels == 2);
  const MacroLevel& level = query.grid.levels[kFine];
  typename DenseGrid<S>::Place place;
  std::int32_t end[3];
  for (int a = 0; a < 3; ++a) end[a] = std::min((brick[a] + 1) * kStrips, level.dims[a]);
  std::uint32_t strips = 0;
  for (std::int32_t z = brick[2] * kStrips; z < end[2]; ++z)
    for (std::int32_t y = brick[1] * kStrips; y < end[1]; ++y) {
      bool active = false;
      for (std::int32_t x = brick[0] * kStrips; x < end[0]; ++x)
        active = active | dense.block_active(kFine, {x, y, z}, place);
      strips |= std::uint32_t(active) << (y % kStrips + z % kStrips * kStrips);
    }
  return strips;
}

// Asks memory for the samples of a strip.
template <class S> void prefetch_strip(const BrickRows<S>& rows, int strip) {
  const int y0 = strip % kStrips * 4, z0 = strip / kStrips * 4;
  for (int z = z0; z <= std::min(z0 + 4, rows.cells[2]); ++z)
    for (int y = y0; y <= std::min(y0 + 4, rows.cells[1]); ++y) {
      __builtin_prefetch(rows.at(y, z));
      __builtin_prefetch(rows.at(y, z) + rows.cells[0]);
    }
}

// Row by row: a cell is active where some of its corners lie below the key and some do not.
template <class S>
void fill_strip(const BrickRows<S>& rows, int strip, typename SampleTraits<S>::Key key, BrickMask& mask) {
  const int y0 = strip % kStrips * 4, z0 = strip / kStrips * 4, y1 = std::min(y0 + 4, rows.cells[1]),
            z1 = std::min(z0 + 4, rows.cells[2]);
  const std::uint32_t inside = (1u << rows.cells[0]) - 1;
  std::uint32_t below[2][5];
  for (int z = z0; z <= z1; ++z) {
    const auto& last = below[~z & 1];
    auto& now = below[z & 1];
    for (int y = y0; y <= y1; ++y) now[y - y0] = row_below(rows.at(y, z), rows.cells[0] + 1, key);
    if (z == z0) continue;
    for (int y = y0; y < y1; ++y) {
      const int i = y - y0;
      const std::uint32_t any = last[i] | last[i + 1] | now[i] | now[i + 1],
                          all = last[i] & last[i + 1] & now[i] & now[i + 1];
      const std::uint32_t active = (any | any >> 1) & ~(all & all >> 1) & inside;
      if (active) add_row(active, y, z - 1, mask);
    }
  }
}

template <class S>
void fill_mask(const DenseGrid<S>& dense, const VolumeQuery& query, int iso, const std::int32_t (&first)[3],
               BrickMask& mask) {
  const BrickRows<S> rows(query.grid, first);
  const auto key = static_cast<typename SampleTraits<S>::Key>(query.key[iso]);
  std::uint32_t rest = active_strips(
      dense, query, {first[0] >> kBrickShift, first[1] >> kBrickShift, first[2] >> kBrickShift});
  for (; rest; rest &= rest - 1) {
    if (const std::uint32_t next = rest & (rest - 1)) prefetch_strip(rows, std::countr_zero(next));
    fill_strip(rows, std::countr_zero(rest), key, mask);
  }
}

// Cell by cell, in those of the eight leaves that may have some.
template <class S>
void fill_mask(const SparseGrid<S>& sparse, const VolumeQuery&, int iso, const std::int32_t (&first)[3],
               BrickMask& mask) {
  constexpr int kLevel = kTreeLevels - 1, kEdge = 1 << kTreeShifts[kLevel];
  typename SparseGrid<S>::Place place;
  for (int leaf = 0; leaf < 8; ++leaf) {
    const int from[3] = {(leaf & 1) * kEdge, (leaf >> 1 & 1) * kEdge, (leaf >> 2) * kEdge};
    std::int32_t block[3];
    for (int a = 0; a < 3; ++a) block[a] = (first[a] + from[a]) >> kTreeShifts[kLevel];
    if (!sparse.block_active(kLevel, block, place)) continue;
    for (int z = from[2]; z < from[2] + kEdge; ++z)
      for (int y = from[1]; y < from[1] + kEdge; ++y) {
        std::uint32_t row = 0;
        for (int x = from[0]; x < from[0] + kEdge; ++x) {
          const std::int32_t cell[3] = {first[0] + x, first[1] + y, first[2] + z};
          row |= (sparse.active_isos(cell, place) >> iso & 1) << x;
        }
        if (row) add_row(row, y, z, mask);
      }
  }
}

}  // namespace

std::unique_ptr<BrickMask> make_mask(const VolumeQuery& query, int iso, const std::int32_t (&first)[3]) {
  auto mask = std::make_unique<BrickMask>();
  visit_grid(query, [&]<class Grid>(GridTag<Grid>) { fill_mask(Grid(query), query, iso, first, *mask); });
  for (int b = 0; b < 64; ++b) mask->blocks |= std::uint64_t(mask->cells[b] != 0) << b;
  return mask->blocks ? std::move(mask) : nullptr;
}

}  // namespace isocast
