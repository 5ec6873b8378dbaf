// The headers of volume files whose samples follow them, little-endian, x fastest.
#pragma once

#include <isocast/data_gen/sample.h>
#include <isocast/volume/sample_type.h>

#include <string>

namespace isocast {

/// What is written: samples of `type` at the grid's positions, values are slope * stored + intercept.
struct StoredVolume {
  SampleGrid grid;
  SampleType type = SampleType::f32;
  double slope = 1, intercept = 0;
};

/// The numbers that an integer type can store; 0 and 0 for floats.
struct IntegerRange {
  double lowest = 0, largest = 0;
};
[[nodiscard]] IntegerRange integer_range(SampleType type);

/// NRRD, attached and raw; for integer types "old min", "old max", isocast_slope and isocast_intercept. A
/// comment fills it up to a multiple of 64 bytes, so that readers can map the samples in place.
[[nodiscard]] std::string nrrd_header(const StoredVolume& volume);

/// MetaImage, local and raw; filled up like NRRD's.
[[nodiscard]] std::string metaimage_header(const StoredVolume& volume);

/// With the sform. NIfTI-1 of 352 bytes, if its 32-bit floats keep every position within a hundredth of the
/// spacing and every value within a hundredth of the slope; else, and where a dimension exceeds 32767,
/// NIfTI-2 of 544 bytes.
[[nodiscard]] std::string nifti_header(const StoredVolume& volume);

/// None.
[[nodiscard]] inline std::string no_header(const StoredVolume&) { return {}; }

}  // namespace isocast
