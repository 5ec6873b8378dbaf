// One ray through every method, held against the truth.
#pragma once

#include <isocast/apps/reference/ray_reference.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/render/camera.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

struct ProbeMethod {
  std::string name;
  std::map<std::string, std::string> settings;  // its `--set` values
};

/// What one method answered.
///
/// t             +inf: no hit; then t_lo and t_hi mean nothing
/// error         |t - that of the first crossing| in the reference's unit; NaN unless both are there
/// work          cubics solved, or evaluations of a formula
/// seconds       of Surface::first_hit on a stream that holds this ray alone: median of several runs of a
///               millisecond or more
/// verdict       right, wrong root, false hit, false miss; undecided: the method cannot tell; unknown: the
///               reference cannot
/// contradiction why what the method claims as proved cannot be; empty: it can
struct ProbeAnswer {
  std::string method, precision;
  double t, t_lo, t_hi;
  Certificate certificate;
  double error;
  std::int64_t work;
  double seconds;
  std::string_view verdict;
  std::string contradiction;
};

struct Probe {
  Double3 origin, direction;
  double unit;
  reference::RayTruth truth;
  std::vector<ProbeAnswer> answers;
};

/// The object of a scene's description that the ray through the centre of pixel (x, y) hits first, by number.
[[nodiscard]] std::optional<std::size_t> object_at(const BuiltScene& built, const View& view, int x, int y);

/// The ray through the centre of pixel (x, y) to the description's only object, a volume or a formula, with
/// each of the methods in float and double.
[[nodiscard]] Probe probe_ray(const SceneDescription& description, const BuiltScene& built, const View& view,
                              int x, int y, const std::vector<ProbeMethod>& methods, Isa isa);

/// Whether a hit or miss with a certificate can be true; the reason why not, else nothing.
[[nodiscard]] std::string contradiction_of(const reference::RayTruth& truth, Certificate certificate,
                                           double t_lo, double t_hi);
/// The word for an answer; t is +inf for a miss.
[[nodiscard]] std::string_view verdict_of(const reference::RayTruth& truth, Certificate certificate,
                                          double t);

}  // namespace isocast
