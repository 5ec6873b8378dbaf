#include <isocast/volume/primary/brick_masks.h>
#include <isocast/volume/sample.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr BrickMask kEmpty = {};

// Bit i set: sample i of a row lies below the key.
template <class S> std::uint32_t row_below(const S* row, int count, typename SampleTraits<S>::Key key) {
  std::uint32_t bits = 0;
  for (int i = 0; i < count; ++i) bits |= std::uint32_t(number(row[i]) < key) << i;
  return bits;
}

// Puts the active cells of row (y, z) of the brick into its blocks.
void add_row(std::uint32_t active, int y, int z, BrickMask& mask) {
  const int block = y / 4 * 4 + z / 4 * 16, shift = y % 4 * 4 + z % 4 * 16;
  for (int x = 0; x < 4; ++x) mask.cells[block + x] |= std::uint64_t(active >> 4 * x & 15) << shift;
}

template <class S> const BrickMask* make_mask(const GridView& grid, double key_number, std::size_t brick) {
  const MacroLevel& bricks = grid.levels[0];
  const auto key = static_cast<typename SampleTraits<S>::Key>(key_number);
  const auto* range = static_cast<const typename SampleTraits<S>::Arithmetic*>(bricks.ranges) + 2 * brick;
  if (!parts_range(range[0], range[1], &key, 1)) return &kEmpty;

  // first sample and cells of the brick per axis
  const std::size_t nx = static_cast<std::size_t>(bricks.dims[0]),
                    ny = static_cast<std::size_t>(bricks.dims[1]);
  const std::size_t at[3] = {brick % nx, brick / nx % ny, brick / nx / ny};
  std::size_t first[3];
  int cells[3];
  for (int a = 0; a < 3; ++a) {
    first[a] = at[a] << kBrickShift;
    cells[a] = static_cast<int>(std::min<std::size_t>(kBrickSize, std::size_t(grid.dims[a]) - 1 - first[a]));
  }
  const std::size_t row = static_cast<std::size_t>(grid.dims[0]),
                    slice = row * static_cast<std::size_t>(grid.dims[1]);
  const S* corner = static_cast<const S*>(grid.samples) + first[2] * slice + first[1] * row + first[0];

  // a cell is active where some of its corners lie below the key and some do not
  auto mask = std::make_unique<BrickMask>();
  const std::uint32_t inside = (1u << cells[0]) - 1;
  std::uint32_t below[2][kBrickSize + 1];
  for (int z = 0; z <= cells[2]; ++z) {
    const auto& last = below[~z & 1];
    auto& now = below[z & 1];
    for (int y = 0; y <= cells[1]; ++y)
      now[y] = row_below(corner + std::size_t(z) * slice + std::size_t(y) * row, cells[0] + 1, key);
    if (z == 0) continue;
    for (int y = 0; y < cells[1]; ++y) {
      const std::uint32_t any = last[y] | last[y + 1] | now[y] | now[y + 1],
                          all = last[y] & last[y + 1] & now[y] & now[y + 1];
      const std::uint32_t active = (any | any >> 1) & ~(all & all >> 1) & inside;
      if (active) add_row(active, y, z - 1, *mask);
    }
  }
  for (int b = 0; b < 64; ++b) mask->blocks |= std::uint64_t(mask->cells[b] != 0) << b;
  return mask.release();
}

}  // namespace

IsoMasks::IsoMasks(const GridView& grid, double key) : grid_(grid), key_(key) {
  const std::int32_t(&n)[3] = grid.levels[0].dims;
  count_ = std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]);
  masks_ = std::make_unique<std::atomic<const BrickMask*>[]>(count_);
}

IsoMasks::~IsoMasks() {
  for (std::size_t i = 0; i < count_; ++i)
    if (const BrickMask* mask = masks_[i]; mask != &kEmpty) delete mask;
}

const BrickMask* IsoMasks::of(std::size_t brick) const {
  std::atomic<const BrickMask*>& slot = masks_[brick];
  const BrickMask* mask = slot.load(std::memory_order_acquire);
  if (!mask) {
    const BrickMask* made = visit_sample_type(
        grid_.type, [&]<class S>(SampleTag<S>) { return make_mask<S>(grid_, key_, brick); });
    if (slot.compare_exchange_strong(mask, made, std::memory_order_acq_rel)) {
      mask = made;
      made_ += made != &kEmpty;
    } else if (made != &kEmpty) delete made;
  }
  return mask->blocks ? mask : nullptr;
}

std::size_t IsoMasks::bytes() const { return count_ * sizeof(masks_[0]) + made_ * sizeof(BrickMask); }

}  // namespace isocast
