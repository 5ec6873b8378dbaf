#include <fmt/format.h>
#include <isocast/base/child_process.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/module.h>
#include <isocast/base/output_file.h>
#include <isocast/base/progress.h>
#include <isocast/data_gen/write_sparse.h>
#include <isocast/volume/io/vdb_image.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

namespace isocast {
namespace {

// The numbers of one leaf in doubles, in the order of SparseLeaf.
struct LeafValues {
  double values[kLeafSamples];
  std::bitset<kLeafSamples> active;
};

bool is_coded(SparseType type) { return type >= SparseType::fp4; }

// A value in the type of the samples; whole numbers rounded and clamped, NaN as zero.
template <class S> S stored(double value) {
  if constexpr (std::is_integral_v<S>) {
    if (!(value == value)) return 0;
    constexpr double kLowest = std::numeric_limits<S>::lowest(), kBeyond = -kLowest;
    const double whole = std::nearbyint(value);
    return whole < kBeyond ? static_cast<S>(std::max(whole, kLowest)) : std::numeric_limits<S>::max();
  } else {
    return static_cast<S>(value);
  }
}

// Sends a grid to OpenVDB's process.
class GridSender {
 public:
  GridSender(ChildProcess& process, SparseType type, double band)
      : process_(process), type_(is_coded(type) ? SparseType::f32 : type), band_(band) {}

  template <class T> void send(const T& value) {
    process_.send({reinterpret_cast<const std::byte*>(&value), sizeof value});
  }
  [[nodiscard]] std::uint64_t bits(double value) const {
    std::uint64_t bits = 0;
    put(value, reinterpret_cast<std::byte*>(&bits));
    return bits;
  }

  // A block that has a value of its own; outside of the band, one value throughout becomes a tile or nothing.
  void send_block(const std::array<std::int32_t, 3>& origin, LeafValues& leaf) {
    if (!std::isnan(band_)) {
      bool inside = true, outside = true;
      for (int n = 0; n < kLeafSamples; ++n) {
        double& v = leaf.values[n];
        leaf.active[n] = leaf.active[n] && std::abs(v) <= band_;
        if (!leaf.active[n]) v = v < 0 ? -band_ : band_;  // NaN: outside
        inside = inside && v == -band_ && !leaf.active[n];
        outside = outside && v == band_ && !leaf.active[n];
      }
      if (outside) return;
      if (inside) return send(VdbPart{VdbPartKind::tile, {origin, kTreeShifts[2], {bits(-band_), 0}}});
    }
    send(VdbPart{VdbPartKind::leaf, {origin, kTreeShifts[2], {0, 0}}});
    std::byte bytes[kLeafSamples * sizeof(double) + 64] = {};
    std::byte* to = bytes;
    for (const double v : leaf.values) to = put(v, to);
    for (int n = 0; n < kLeafSamples; ++n)
      if (leaf.active[n]) to[n >> 3] |= std::byte(1 << (n & 7));
    process_.send({bytes, static_cast<std::size_t>(to + 64 - bytes)});
  }

 private:
  // Returns where the next number goes.
  std::byte* put(double value, std::byte* to) const {
    return visit_sparse_type(type_, [&]<class S>(SparseTag<S>) -> std::byte* {
      if constexpr (std::is_arithmetic_v<S>) {
        const S number = stored<S>(value);
        std::memcpy(to, &number, sizeof number);
        return to + sizeof number;
      } else {
        return to;  // codes are sent as floats
      }
    });
  }

  ChildProcess& process_;
  SparseType type_;
  double band_;
};

// Rows [j, j + rows) of eight layers from k on, and the blocks in them.
class Slab {
 public:
  Slab(const SampleGrid& grid, std::int64_t rows)
      : grid_(grid), rows_(rows), values_(static_cast<std::size_t>(8 * rows * grid.dims[0])) {}

  void sample(const Field& field, std::int64_t j, std::int64_t k, ValueStatistics& statistics) {
    j_ = j;
    k_ = k;
    for (std::int64_t layer = k; layer < std::min(k + 8, grid_.dims[2]); ++layer) {
      const std::int64_t first = layer * grid_.dims[1] + j,
                         last = layer * grid_.dims[1] + std::min(j + rows_, grid_.dims[1]);
      statistics = merged(
          statistics,
          sample_rows(field, grid_, first, last, [&](std::int64_t row, std::span<const double> values) {
            std::ranges::copy(values, values_.begin() + ((layer - k) * rows_ + row - first) * grid_.dims[0]);
          }));
    }
  }
  void send(GridSender& sender, double background) const {
    LeafValues leaf;
    for (std::int64_t y = j_; y < std::min(j_ + rows_, grid_.dims[1]); y += 8)
      for (std::int64_t x = 0; x < grid_.dims[0]; x += 8) {
        for (int n = 0; n < kLeafSamples; ++n) {
          const std::int64_t i = x + (n >> 6), j = y + (n >> 3 & 7), k = k_ + (n & 7);
          leaf.active[n] = i < grid_.dims[0] && j < grid_.dims[1] && k < grid_.dims[2];
          leaf.values[n] =
              leaf.active[n]
                  ? values_[static_cast<std::size_t>(((k - k_) * rows_ + j - j_) * grid_.dims[0] + i)]
                  : background;
        }
        sender.send_block(
            {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(k_)},
            leaf);
      }
  }

 private:
  const SampleGrid& grid_;
  std::int64_t rows_, j_ = 0, k_ = 0;
  std::vector<double> values_;
};

VdbOrder make_order(const SampleGrid& grid, const std::filesystem::path& target,
                    const SparseWriteOptions& options) {
  VdbOrder order = {};
  order.codes = options.type;
  order.type = is_coded(options.type) ? SparseType::f32 : options.type;
  order.nanovdb = target.extension() == ".nvdb";
  order.level_set = !std::isnan(options.band);
  for (int a = 0; a < 3; ++a) {
    order.world_from_grid[a][a] = grid.spacing(a);
    order.world_from_grid[a][3] = grid.domain.lo[a];
  }
  const std::string name = options.name.empty() ? target.stem().string() : options.name;
  name.copy(order.name, sizeof order.name - 1);
  return order;
}

}  // namespace

bool is_sparse_file(const std::filesystem::path& target) {
  return target.extension() == ".vdb" || target.extension() == ".nvdb";
}

SparseType sparse_type_for(const std::filesystem::path& target, const std::string& word) {
  constexpr SparseType kVdb[] = {SparseType::f32, SparseType::f64, SparseType::i32, SparseType::i64};
  constexpr SparseType kNanoVdb[] = {SparseType::f32, SparseType::f64,  SparseType::i16,
                                     SparseType::i32, SparseType::i64,  SparseType::fp4,
                                     SparseType::fp8, SparseType::fp16, SparseType::fpn};
  const bool nano = target.extension() == ".nvdb";
  const std::span<const SparseType> types = nano ? std::span<const SparseType>(kNanoVdb) : kVdb;
  std::string names;
  for (const SparseType type : types) {
    if (name_of(type) == word) return type;
    names += fmt::format(" {}", name_of(type));
  }
  const bool small = word.size() == 2 || word.starts_with("f1") || word.starts_with("fp");
  const std::string_view nearest = word.starts_with('f') ? "f32" : nano && small ? "i16" : "i32";
  throw InputError(fmt::format("found the sample type {} for {}, expected one of{} (the nearest is {})", word,
                               target.extension().string(), names, nearest));
}

WriteReport write_sparse_field(const Field& field, const SampleGrid& grid,
                               const std::filesystem::path& target, const SparseWriteOptions& options) {
  check_grid(grid, 8);
  if (options.band <= 0 || std::isinf(options.band))
    throw InputError(fmt::format("found a band of {}, expected a width above 0", options.band));
  const std::filesystem::path program = find_part("isocast_openvdb");
  if (program.empty())
    throw InputError(
        fmt::format("cannot write {}: it needs the part 'openvdb' (isocast_openvdb), which this build does "
                    "not have",
                    target.string()));
  OutputFile file(target);
  ChildProcess process(program, {"write", file.temporary().string()}, {});
  GridSender sender(process, options.type, options.band);
  VdbOrder order = make_order(grid, target, options);
  const double background = std::isnan(options.band) ? options.background : options.band;
  order.background = sender.bits(background);
  sender.send(order);

  constexpr std::int64_t kSlabBytes = std::int64_t(64) << 20;
  const std::int64_t rows = std::clamp(kSlabBytes / (64 * grid.dims[0]) & ~std::int64_t(7), std::int64_t(8),
                                       (grid.dims[1] + 7) & ~std::int64_t(7));
  Slab slab(grid, rows);
  WriteReport report;
  Progress progress("sampling", grid.dims[2]);
  for (std::int64_t k = 0; k < grid.dims[2]; k += 8) {
    for (std::int64_t j = 0; j < grid.dims[1]; j += rows) {
      throw_if_interrupted();
      slab.sample(field, j, k, report.values);
      slab.send(sender, background);
    }
    progress.add(std::min<std::int64_t>(8, grid.dims[2] - k));
  }
  sender.send(VdbPart{VdbPartKind::end, {}});
  const ChildProcess::End end = process.finish();
  if (end.status != 0)
    throw InputError(fmt::format(
        "cannot write {}: {}", target.string(),
        end.status == 2 ? end.message : fmt::format("OpenVDB's process ended with {}", end.status)));
  file.commit();
  report.bytes = static_cast<std::int64_t>(std::filesystem::file_size(target));
  return report;
}

}  // namespace isocast
