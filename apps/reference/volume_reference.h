// The truth about a volume and a ray: every root of the trilinear interpolant, in exact arithmetic.
#pragma once

#include <isocast/apps/reference/ray_reference.h>
#include <isocast/apps/reference/volume_cells.h>

namespace isocast::reference {

/// f is the trilinear interpolant of the stored samples in the cells that VolumeSurface has; the iso-values,
/// in the file's scaled units, become stored units in double precision as there, and are exact from then on.
/// The ray is taken to grid space by the stored matrix without rounding. Shares with the program how a sample
/// is read, and nothing else.
///
/// doubts  Doubt::zero, where f is iso along a part of the ray; Doubt::work for the whole of a ray that meets
///         more than some 10^5 cells with an iso-value
/// source  of the cubic: Parker et al.: Interactive ray tracing for isosurface rendering, Visualization 1998
class VolumeReference final : public RayReference {
 public:
  /// Throws InputError for iso-values that are not finite and volumes with fewer than two samples an axis.
  VolumeReference(std::shared_ptr<const Volume> volume, std::vector<double> iso);

  [[nodiscard]] RayTruth solve(const Double3& o, const Double3& d, double t0, double t1) const override;
  [[nodiscard]] double unit() const override { return unit_; }
  [[nodiscard]] std::string identity() const override;

 private:
  std::unique_ptr<VolumeCells> cells_;
  Transform grid_from_world_;
  std::vector<double> iso_;  // in stored units
  double unit_ = 0;
};

}  // namespace isocast::reference
