#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/output_file.h>
#include <isocast/base/progress.h>
#include <isocast/data_gen/volume_header.h>
#include <isocast/data_gen/write.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <type_traits>
#include <vector>

namespace isocast {
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "samples are written as they are in memory");

namespace {

// How values become stored numbers: lowest + (value - lo) * scale in integers; floats stay.
struct Mapping {
  double lo = 0, scale = 1, slope = 1;
};

using Convert = void (*)(std::span<const double>, const Mapping&, std::byte* out);

template <class S> void convert(std::span<const double> values, const Mapping& mapping, std::byte* out) {
  for (const double value : values) {
    S stored;
    if constexpr (std::is_integral_v<S>) {
      // a NaN fails the first comparison
      constexpr double kLowest = std::numeric_limits<S>::lowest(), kLargest = std::numeric_limits<S>::max();
      const double scaled = std::floor((value - mapping.lo) * mapping.scale + 0.5);
      stored = static_cast<S>(scaled > 0 ? std::min(scaled + kLowest, kLargest) : kLowest);
    } else {
      stored = static_cast<S>(value);
    }
    std::memcpy(out, &stored, sizeof stored);
    out += sizeof stored;
  }
}

Convert convert_to(SampleType type) {
  return visit_sample_type(type, []<class S>(SampleTag<S>) -> Convert {
    if constexpr (std::is_same_v<S, Half>) return convert<_Float16>;
    else return convert<S>;
  });
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

// The range that becomes lowest ... largest: as asked for, else that of a first pass over the samples.
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

// A range of one value maps it to the lowest number, and that back to it.
Mapping make_mapping(const ValueRange& range, const IntegerRange& stored) {
  const double extent = range.hi - range.lo, steps = stored.largest - stored.lowest;
  if (!(extent >= 0) || !std::isfinite(extent))
    throw InputError(
        fmt::format("found the range {},{}, expected a finite LO not above HI", range.lo, range.hi));
  return extent > 0 ? Mapping{range.lo, steps / extent, extent / steps} : Mapping{range.lo, 0, 1};
}

// Header, then slab after slab.
template <std::string (*header)(const StoredVolume&)>
WriteReport write_slabs(const Field& field, const SampleGrid& grid, const fs::path& target,
                        const WriteOptions& options) {
  OutputFile file(target);
  std::ofstream out(file.temporary(), std::ios::binary);

  // how values are stored
  const std::int64_t row_bytes = grid.dims[0] * static_cast<std::int64_t>(size_of(options.type));
  const std::int64_t rows_at_once = std::clamp(options.slab_bytes / row_bytes, std::int64_t{1}, grid.rows());
  const Convert store_values = convert_to(options.type);
  WriteReport report;
  Mapping mapping;
  if (!is_float(options.type)) {
    const IntegerRange stored = integer_range(options.type);
    mapping = make_mapping(mapped_range(field, grid, options, rows_at_once), stored);
    report.slope = mapping.slope;
    report.intercept = mapping.lo - mapping.slope * stored.lowest;
  }

  out << header({grid, options.type, report.slope, report.intercept});
  std::vector<std::byte> slab(static_cast<std::size_t>(rows_at_once * row_bytes));
  const auto check_written = [&] {
    if (!out) throw InputError(fmt::format("cannot write {}: {}", target.string(), std::strerror(errno)));
  };
  for_slabs(grid, rows_at_once, "sampling", [&](std::int64_t first, std::int64_t last) {
    const auto store = [&](std::int64_t row, std::span<const double> values) {
      store_values(values, mapping, slab.data() + (row - first) * row_bytes);
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

constexpr SampleType kAllButHalf[] = {SampleType::u8,  SampleType::i8,  SampleType::u16, SampleType::i16,
                                      SampleType::u32, SampleType::i32, SampleType::f32, SampleType::f64};
constexpr SampleType kAll[] = {SampleType::u8,  SampleType::i8,  SampleType::u16,
                               SampleType::i16, SampleType::u32, SampleType::i32,
                               SampleType::f16, SampleType::f32, SampleType::f64};

// A format: its types, those of a kind by size, and its writer, which is given one of them and a good grid.
struct Format {
  std::string_view extension;
  std::span<const SampleType> types;
  WriteReport (*write)(const Field&, const SampleGrid&, const fs::path&, const WriteOptions&);
};
constexpr Format kFormats[] = {{".nrrd", kAllButHalf, write_slabs<nrrd_header>},
                               {".raw", kAll, write_slabs<no_header>},
                               {".nii", kAllButHalf, write_slabs<nifti_header>},
                               {".mha", kAllButHalf, write_slabs<metaimage_header>}};

const Format* find_format(const fs::path& target) {
  const auto found = std::ranges::find(kFormats, target.extension().string(), &Format::extension);
  return found == std::end(kFormats) ? nullptr : &*found;
}

const Format& format_of(const fs::path& target) {
  if (const Format* const found = find_format(target)) return *found;
  std::string extensions;
  for (const Format& format : kFormats) extensions += fmt::format(" {}", format.extension);
  throw InputError(
      fmt::format("found the output {}, expected a name that ends in one of{}", target.string(), extensions));
}

// The nearest type is the first of the same kind that is large enough.
void check_type(const Format& format, SampleType type) {
  if (std::ranges::find(format.types, type) != format.types.end()) return;
  const auto nearest = std::ranges::find_if(format.types, [&](SampleType t) {
    return is_float(t) == is_float(type) && size_of(t) >= size_of(type);
  });
  std::string names;
  for (const SampleType t : format.types) names += fmt::format(" {}", name_of(t));
  throw InputError(fmt::format("found the sample type {} for {}, expected one of{} (the nearest is {})",
                               name_of(type), format.extension, names,
                               name_of(nearest == format.types.end() ? format.types.back() : *nearest)));
}

}  // namespace

bool is_dense_file(const fs::path& target) { return find_format(target) != nullptr; }

WriteReport write_field(const Field& field, const SampleGrid& grid, const fs::path& target,
                        const WriteOptions& options) {
  // everything that can be refused is refused before the first sample
  const Format& format = format_of(target);
  check_type(format, options.type);
  check_grid(grid, static_cast<std::int64_t>(size_of(options.type)));
  return format.write(field, grid, target, options);
}

}  // namespace isocast
