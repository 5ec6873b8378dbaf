// A volume as it was read: samples in the type of the file, where they lie in the world, how they are scaled.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/volume/sample_type.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace isocast {

/// dims[0] varies fastest: sample (i, j, k) is element i + dims[0] * (j + dims[1] * k), in native byte order.
/// Grid space has samples at the integers; world_from_grid maps it to the world (spacing, origin and axes in
/// one, possibly left-handed). Users see values v = slope * stored + intercept. `storage` keeps the samples
/// alive (a mapping or a buffer).
struct Volume {
  SampleType type = SampleType::u8;
  std::array<std::int64_t, 3> dims = {0, 0, 0};
  const std::byte* samples = nullptr;
  std::shared_ptr<const void> storage;
  Transform world_from_grid;
  double slope = 1, intercept = 0;
  std::string format;   // "raw", "nrrd", "nifti", "vti"
  bool mapped = false;  // the samples are pages of the file, not a copy

  [[nodiscard]] std::int64_t count() const { return dims[0] * dims[1] * dims[2]; }
  [[nodiscard]] std::int64_t bytes() const { return count() * static_cast<std::int64_t>(size_of(type)); }
};

}  // namespace isocast
