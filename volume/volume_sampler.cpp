#include <isocast/volume/sample.h>
#include <isocast/volume/volume_sampler.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {

VolumeSampler::VolumeSampler(std::shared_ptr<const Volume> volume)
    : volume_(std::move(volume)), grid_from_world_(volume_->world_from_grid.inverse()) {
  for (std::size_t a = 0; a < 3; ++a) {
    first_[a] = volume_->tree ? volume_->tree->first_active()[a] : 0;
    last_[a] =
        volume_->tree ? volume_->tree->last_active()[a] : static_cast<std::int32_t>(volume_->dims[a] - 1);
  }
}

double VolumeSampler::value_at(const Double3& world) const {
  const Double3 p = grid_from_world_.point(world);
  std::int32_t cell[3];
  double part[3];
  for (int a = 0; a < 3; ++a) {
    // roundings of points on the border, a millionth of a voxel
    constexpr double kRoom = 1e-6;
    if (!(p[a] >= first_[a] - kRoom && p[a] <= last_[a] + kRoom))
      return std::numeric_limits<double>::quiet_NaN();
    const double inside = std::clamp(p[a], double(first_[a]), double(last_[a]));
    cell[a] = std::max(first_[a], std::min(static_cast<std::int32_t>(inside), last_[a] - 1));
    part[a] = inside - cell[a];
  }
  const Volume& volume = *volume_;
  const auto at = [&](int k) -> double {
    std::int32_t c[3];
    for (int a = 0; a < 3; ++a) c[a] = std::min(cell[a] + (k >> a & 1), last_[a]);
    if (volume.tree)
      return visit_sparse_type(volume.tree->type(), [&]<class S>(SparseTag<S>) {
        return double(number(sample_at<S>(volume.tree->view(), c)));
      });
    return visit_sample_type(volume.type, [&]<class S>(SampleTag<S>) {
      const std::int64_t i = c[0] + volume.dims[0] * (c[1] + volume.dims[1] * std::int64_t{c[2]});
      return double(number(reinterpret_cast<const S*>(volume.samples)[i]));
    });
  };
  double value = 0;
  for (int k = 0; k < 8; ++k) {
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= k >> a & 1 ? part[a] : 1 - part[a];
    if (weight > 0) value += weight * at(k);
  }
  return volume.slope * value + volume.intercept;
}

}  // namespace isocast
