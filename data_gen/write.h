// Fields to volume files, a slab at a time.
#pragma once

#include <isocast/data_gen/sample.h>
#include <isocast/volume/sample_type.h>

#include <filesystem>
#include <optional>

namespace isocast {

struct ValueRange {
  double lo, hi;
};

struct WriteOptions {
  SampleType type = SampleType::f32;     // u8, u16, f32 or f64
  std::optional<ValueRange> range = {};  // of integer types, mapped to 0 ... largest; else the sampled range
  std::int64_t slab_bytes = std::int64_t{64} << 20;  // of samples in memory at once; at least a row is
};

/// What was written: values are slope * stored + intercept. NaN became 0 in integer types.
struct WriteReport {
  ValueStatistics values;
  double slope = 1, intercept = 0;
  std::int64_t bytes = 0;
};

/// The extensions that write_field knows: ".nrrd" and ".raw". Throws InputError for any other, naming these.
void check_volume_extension(const std::filesystem::path& target);

/// Samples `field` and writes it little-endian, x fastest.
///
/// .nrrd     attached header, raw encoding; origin and directions place sample (0, 0, 0) at domain.lo and the
///           last one at domain.hi; integer types carry "old min" and "old max", and isocast_slope and
///           isocast_intercept
/// .raw      the samples and nothing else
/// integers  round((v - lo) / (hi - lo) * largest), clamped
/// throws    InputError for another extension or type, a bad grid or range, or when the file cannot be
///           written; what was there before stays until the new file is complete
WriteReport write_field(const Field& field, const SampleGrid& grid, const std::filesystem::path& target,
                        const WriteOptions& options);

}  // namespace isocast
