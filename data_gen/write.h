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
  SampleType type = SampleType::f32;
  std::optional<ValueRange> range = {};  // becomes all numbers of an integer type; else the sampled range
  std::int64_t slab_bytes = std::int64_t{64} << 20;  // of samples in memory at once; at least a row is
};

/// What was written: values are slope * stored + intercept. NaN became the lowest integer.
struct WriteReport {
  ValueStatistics values;
  double slope = 1, intercept = 0;
  std::int64_t bytes = 0;
};

/// Whether write_field knows the extension: .nrrd .raw .nii .mha.
[[nodiscard]] bool is_dense_file(const std::filesystem::path& target);

/// Samples `field` and writes it little-endian, x fastest.
///
/// headers   those of volume_header.h, none for .raw: sample (0, 0, 0) is at domain.lo and the last one at
///           domain.hi; values are scaled as the report says
/// types     all but f16, which only .raw has
/// integers  lowest + round((v - lo) / (hi - lo) * (largest - lowest)), clamped
/// throws    InputError for another extension or type, a bad grid or range, or when the file cannot be
///           written; what was there before stays until the new file is complete
WriteReport write_field(const Field& field, const SampleGrid& grid, const std::filesystem::path& target,
                        const WriteOptions& options);

}  // namespace isocast
