// The ray through a pixel: what every method answers, and what f is like along it.
#pragma once

#include <isocast/apps/viewer/idle_work.h>
#include <isocast/apps/viewer/pixel_ray.h>

#include <span>

namespace isocast::viewer {

/// f in the user's units at equal steps of t from t0 to t1, NaN where it is not defined.
///
/// borders  t at which the ray goes from one cell of a volume to the next; empty for formulas
struct RayProfile {
  double t0 = 0, t1 = 0;
  std::vector<float> values;
  std::vector<double> borders;
};

/// x, y: the pixel. object: its name; empty where there is only one. profile is empty where the ray passes
/// beside the domain. unit: its name.
struct PixelProbe {
  int x = 0, y = 0;
  Probe probe;
  RayProfile profile;
  std::vector<double> iso;
  std::string object, unit, error;
};

/// Every applicable method in float and double, as `isocast probe` has it, of the object that is hit there,
/// or of `otherwise` where there is none; the scene is left as it was. Throws Interrupted.
[[nodiscard]] PixelProbe probe_pixel(const JobScene& scene, int x, int y, std::size_t otherwise = 0);

/// The part of a ray of the world inside the bounds of a volume or a formula, at `steps` + 1 points.
[[nodiscard]] RayProfile profile_along(const BuiltObject& object, const PixelRay& ray, int steps);

}  // namespace isocast::viewer
