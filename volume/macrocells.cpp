#include <isocast/volume/macrocells.h>
#include <isocast/volume/sample.h>
#include <oneapi/tbb/blocked_range2d.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>

namespace isocast {
namespace {

constexpr int kShifts[kMacroLevels] = {4, 2};  // coarse, fine; measured: docs/accuracy.md

template <class A> constexpr A lowest() {
  return std::numeric_limits<A>::has_infinity ? -std::numeric_limits<A>::infinity()
                                              : std::numeric_limits<A>::lowest();
}
template <class A> constexpr A highest() {
  return std::numeric_limits<A>::has_infinity ? std::numeric_limits<A>::infinity()
                                              : std::numeric_limits<A>::max();
}

// Ranges of one row of fine blocks: first over the rows of samples, sample by sample, then along x. Whether
// all samples are finite.
template <class S>
bool scan_row(const Volume& volume, const MacroLevel& level, std::int64_t by, std::int64_t bz,
              typename SampleTraits<S>::Arithmetic* ranges) {
  using A = typename SampleTraits<S>::Arithmetic;
  const std::int64_t n = volume.dims[0], size = std::int64_t(1) << level.shift;
  const auto last = [&](std::int64_t block, int axis) {
    return std::min((block + 1) * size, volume.dims[axis] - 1);
  };
  std::vector<A> low(n, highest<A>()), high(n, lowest<A>());
  A beyond = 0;
  for (std::int64_t z = bz * size; z <= last(bz, 2); ++z)
    for (std::int64_t y = by * size; y <= last(by, 1); ++y) {
      const S* row = reinterpret_cast<const S*>(volume.samples) + (z * volume.dims[1] + y) * n;
      for (std::int64_t x = 0; x < n; ++x) {
        const A v = number(row[x]);
        if constexpr (std::is_floating_point_v<A>) beyond += v * 0;  // NaN for what is not finite
        low[x] = v < low[x] ? v : low[x];
        high[x] = v > high[x] ? v : high[x];
      }
    }
  for (std::int64_t bx = 0; bx < level.dims[0]; ++bx) {
    A lo = highest<A>(), hi = lowest<A>();
    for (std::int64_t x = bx * size; x <= last(bx, 0); ++x) {
      lo = std::min(lo, low[x]);
      hi = std::max(hi, high[x]);
    }
    ranges[2 * bx] = lo;
    ranges[2 * bx + 1] = hi;
  }
  return beyond == 0;
}

// A coarse block is the union of its fine blocks.
template <class A>
void gather(const MacroLevel& fine, const MacroLevel& coarse, std::int64_t by, std::int64_t bz, A* ranges) {
  const int factor = 1 << (coarse.shift - fine.shift);
  const A* from = static_cast<const A*>(fine.ranges);
  for (std::int64_t bx = 0; bx < coarse.dims[0]; ++bx) {
    A lo = highest<A>(), hi = lowest<A>();
    for (std::int64_t z = bz * factor; z < std::min<std::int64_t>((bz + 1) * factor, fine.dims[2]); ++z)
      for (std::int64_t y = by * factor; y < std::min<std::int64_t>((by + 1) * factor, fine.dims[1]); ++y)
        for (std::int64_t x = bx * factor; x < std::min<std::int64_t>((bx + 1) * factor, fine.dims[0]); ++x) {
          const A* range = from + 2 * ((z * fine.dims[1] + y) * fine.dims[0] + x);
          lo = std::min(lo, range[0]);
          hi = std::max(hi, range[1]);
        }
    ranges[2 * bx] = lo;
    ranges[2 * bx + 1] = hi;
  }
}

}  // namespace

MacroCells::MacroCells(const Volume& volume) : type_(volume.type) {
  std::atomic<bool> finite = true;
  visit_sample_type(volume.type, [&](auto tag) {
    using S = typename decltype(tag)::Type;
    using A = typename SampleTraits<S>::Arithmetic;
    for (int i = kMacroLevels - 1; i >= 0; --i) {
      MacroLevel& level = levels_[i];
      level.shift = kShifts[i];
      for (int a = 0; a < 3; ++a)
        level.dims[a] = static_cast<std::int32_t>((volume.dims[a] - 2) >> level.shift) + 1;
      const std::size_t blocks =
          std::size_t(level.dims[0]) * std::size_t(level.dims[1]) * std::size_t(level.dims[2]);
      ranges_[i].resize(2 * blocks * sizeof(A));
      A* ranges = reinterpret_cast<A*>(ranges_[i].data());
      level.ranges = ranges;
      using Rows = oneapi::tbb::blocked_range2d<std::int64_t>;
      oneapi::tbb::parallel_for(Rows(0, level.dims[2], 0, level.dims[1]), [&](const Rows& rows) {
        for (std::int64_t bz = rows.rows().begin(); bz < rows.rows().end(); ++bz)
          for (std::int64_t by = rows.cols().begin(); by < rows.cols().end(); ++by) {
            A* row = ranges + 2 * (bz * level.dims[1] + by) * level.dims[0];
            if (i == kMacroLevels - 1) {
              if (!scan_row<S>(volume, level, by, bz, row)) finite = false;
            } else gather<A>(levels_[i + 1], level, by, bz, row);
          }
      });
    }
  });
  finite_ = finite;
}

BlockBox MacroCells::active_box(std::span<const double> keys) const {
  const MacroLevel& level = levels_[0];
  BlockBox box{{level.dims[0], level.dims[1], level.dims[2]}, {-1, -1, -1}};
  visit_sample_type(type_, [&](auto tag) {
    using S = typename decltype(tag)::Type;
    const auto* range = static_cast<const typename SampleTraits<S>::Arithmetic*>(level.ranges);
    for (std::int32_t z = 0; z < level.dims[2]; ++z)
      for (std::int32_t y = 0; y < level.dims[1]; ++y)
        for (std::int32_t x = 0; x < level.dims[0]; ++x, range += 2) {
          const bool active = std::ranges::any_of(keys, [&](double k) {
            const auto key = static_cast<typename SampleTraits<S>::Key>(k);
            return range[0] < key && !(range[1] < key);
          });
          if (!active) continue;
          const std::int32_t at[3] = {x, y, z};
          for (int a = 0; a < 3; ++a) {
            box.lo[a] = std::min(box.lo[a], at[a]);
            box.hi[a] = std::max(box.hi[a], at[a]);
          }
        }
  });
  return box;
}

std::size_t MacroCells::bytes() const {
  std::size_t sum = 0;
  for (const auto& ranges : ranges_) sum += ranges.size();
  return sum;
}

}  // namespace isocast
