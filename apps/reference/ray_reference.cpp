#include <fmt/format.h>
#include <isocast/apps/reference/ray_reference.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::reference {

void require_ray(const Double3& o, const Double3& d, double t0, double t1) {
  const auto require_finite = [](const char* name, double x) {
    if (!std::isfinite(x))
      throw InputError(fmt::format("{} of the reference is {}, expected a finite number", name, x));
  };
  for (std::size_t a = 0; a < 3; ++a) {
    require_finite("the origin", o[a]);
    require_finite("the direction", d[a]);
  }
  require_finite("the range's begin", t0);
  require_finite("the range's end", t1);
  if (!(t0 < t1))
    throw InputError(
        fmt::format("the range of the reference is {} to {}, expected one that is not empty", t0, t1));
}

void finish(RayTruth& truth, double units_per_t) {
  std::ranges::sort(truth.roots, {}, &RayRoot::lo);
  std::ranges::sort(truth.doubts, {}, &DoubtfulRange::lo);
  for (RayRoot& root : truth.roots) root.distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < truth.roots.size(); ++i) {
    RayRoot &near = truth.roots[i - 1], &far = truth.roots[i];
    const double distance = std::max(0.0, far.lo - near.hi) * units_per_t;
    near.distance = std::min(near.distance, distance);
    far.distance = distance;
  }
}

}  // namespace isocast::reference
