// A volume's values at places of the world.
#pragma once

#include <isocast/volume/volume.h>

#include <memory>

namespace isocast {

/// Trilinear interpolation of the samples in double precision, in the user's units (slope and intercept).
class VolumeSampler {
 public:
  explicit VolumeSampler(std::shared_ptr<const Volume> volume);

  /// NaN outside the grid (of a sparse one: outside the box of its active samples).
  [[nodiscard]] double value_at(const Double3& world) const;

 private:
  std::shared_ptr<const Volume> volume_;
  Transform grid_from_world_;
  std::int32_t first_[3], last_[3];  // grid points
};

}  // namespace isocast
