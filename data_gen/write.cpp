#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/output_file.h>
#include <isocast/base/progress.h>
#include <isocast/data_gen/write.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <type_traits>
#include <vector>

namespace isocast {
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "samples are written as they are in memory");

namespace {

// How values become stored numbers. Floats stay: scale 1, lo 0.
struct Mapping {
  double lo = 0, scale = 1, slope = 1;
};

template <class S> void convert(std::span<const double> values, const Mapping& mapping, std::byte* out) {
  for (const double value : values) {
    S stored;
    if constexpr (std::is_floating_point_v<S>) {
      stored = static_cast<S>(value);
    } else {
      // a NaN fails the first comparison
      const double scaled = std::floor((value - mapping.lo) * mapping.scale + 0.5),
                   largest = std::numeric_limits<S>::max();
      stored = scaled > 0 ? static_cast<S>(std::min(scaled, largest)) : S(0);
    }
    std::memcpy(out, &stored, sizeof stored);
    out += sizeof stored;
  }
}

// The types that can be written.
struct StoredType {
  SampleType type;
  std::string_view nrrd_name;
  double largest;  // of integers
  void (*convert)(std::span<const double>, const Mapping&, std::byte* out);
};
constexpr StoredType kStoredTypes[] = {{SampleType::u8, "uint8", 255, convert<std::uint8_t>},
                                       {SampleType::u16, "uint16", 65535, convert<std::uint16_t>},
                                       {SampleType::f32, "float", 0, convert<float>},
                                       {SampleType::f64, "double", 0, convert<double>}};

const StoredType& stored_type(SampleType type) {
  const auto found = std::ranges::find(kStoredTypes, type, &StoredType::type);
  if (found != std::end(kStoredTypes)) return *found;
  throw InputError(fmt::format("found the sample type {}, expected u8, u16, f32 or f64 (the nearest is {})",
                               name_of(type),
                               type == SampleType::i8    ? "u8"
                               : type == SampleType::f16 ? "f32"
                                                         : "u16"));
}

// Calls visit(first, last) for slabs of rows, in order.
template <class Visit>
void for_slabs(const SampleGrid& grid, std::int64_t rows_at_once, const char* what, Visit visit) {
  Progress progress(what, grid.rows());
  for (std::int64_t first = 0; first < grid.rows(); first += rows_at_once) {
    throw_if_interrupted();
    const std::int64_t last = std::min(first + rows_at_once, grid.rows());
    visit(first, last);
    progress.add(last - first);
  }
}

// The range that becomes 0 ... largest: as asked for, else that of a first pass over the samples.
ValueRange mapped_range(const Field& field, const SampleGrid& grid, const WriteOptions& options,
                        std::int64_t rows_at_once) {
  if (options.range) return *options.range;
  ValueStatistics found;
  for_slabs(grid, rows_at_once, "range", [&](std::int64_t first, std::int64_t last) {
    const auto ignore = [](std::int64_t, std::span<const double>) {};
    found = merged(found, sample_rows(field, grid, first, last, ignore));
  });
  return found.lo <= found.hi ? ValueRange{found.lo, found.hi} : ValueRange{0, 0};
}

// A range of one value maps it to 0, and 0 back to it.
Mapping make_mapping(const ValueRange& range, double largest) {
  const double extent = range.hi - range.lo;
  if (!(extent >= 0) || !std::isfinite(extent))
    throw InputError(
        fmt::format("found the range {},{}, expected a finite LO not above HI", range.lo, range.hi));
  return extent > 0 ? Mapping{range.lo, largest / extent, extent / largest} : Mapping{range.lo, 0, 1};
}

std::string nrrd_header(const SampleGrid& grid, const StoredType& stored, const Mapping& mapping) {
  std::string header = fmt::format(
      "NRRD0005\n# sampled by isocast\ntype: {}\ndimension: 3\nspace dimension: 3\nsizes: {} {} {}\nendian: "
      "little\n"
      "encoding: raw\nspace directions: ({},0,0) (0,{},0) (0,0,{})\nspace origin: ({},{},{})\n",
      stored.nrrd_name, grid.dims[0], grid.dims[1], grid.dims[2], grid.spacing(0), grid.spacing(1),
      grid.spacing(2), grid.domain.lo[0], grid.domain.lo[1], grid.domain.lo[2]);
  if (!is_float(stored.type))
    header += fmt::format("old min: {}\nold max: {}\nisocast_slope:={}\nisocast_intercept:={}\n", mapping.lo,
                          mapping.lo + stored.largest * mapping.slope, mapping.slope, mapping.lo);
  // a comment fills up to whole multiples of 64 bytes, so that readers can map the samples in place
  constexpr std::size_t kAlignment = 64;
  const std::size_t rest = (header.size() + 3) % kAlignment;  // "#" and two line ends follow
  return header + "#" + std::string((kAlignment - rest) % kAlignment, ' ') + "\n\n";
}

}  // namespace

void check_volume_extension(const fs::path& target) {
  if (target.extension() != ".nrrd" && target.extension() != ".raw")
    throw InputError(
        fmt::format("found the output {}, expected a name that ends in .nrrd or .raw", target.string()));
}

WriteReport write_field(const Field& field, const SampleGrid& grid, const fs::path& target,
                        const WriteOptions& options) {
  // everything that can be refused is refused before the first sample
  check_volume_extension(target);
  const StoredType& stored = stored_type(options.type);
  const auto sample_bytes = static_cast<std::int64_t>(size_of(options.type));
  check_grid(grid, sample_bytes);
  OutputFile file(target);
  std::ofstream out(file.temporary(), std::ios::binary);

  // how values are stored
  const std::int64_t row_bytes = grid.dims[0] * sample_bytes;
  const std::int64_t rows_at_once = std::clamp(options.slab_bytes / row_bytes, std::int64_t{1}, grid.rows());
  WriteReport report;
  Mapping mapping;
  if (!is_float(options.type)) {
    mapping = make_mapping(mapped_range(field, grid, options, rows_at_once), stored.largest);
    report.slope = mapping.slope;
    report.intercept = mapping.lo;
  }

  // header, then slab after slab
  if (target.extension() == ".nrrd") out << nrrd_header(grid, stored, mapping);
  std::vector<std::byte> slab(static_cast<std::size_t>(rows_at_once * row_bytes));
  const auto check_written = [&] {
    if (!out) throw InputError(fmt::format("cannot write {}: {}", target.string(), std::strerror(errno)));
  };
  for_slabs(grid, rows_at_once, "sampling", [&](std::int64_t first, std::int64_t last) {
    const auto store = [&](std::int64_t row, std::span<const double> values) {
      stored.convert(values, mapping, slab.data() + (row - first) * row_bytes);
    };
    report.values = merged(report.values, sample_rows(field, grid, first, last, store));
    out.write(reinterpret_cast<const char*>(slab.data()), (last - first) * row_bytes);
    check_written();
    report.bytes += (last - first) * row_bytes;
  });
  out.close();
  check_written();
  file.commit();
  return report;
}

}  // namespace isocast
