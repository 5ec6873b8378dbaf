// Where objects stand, and the solids that cut them, from a user's numbers.
#pragma once

#include <isocast/math/transform.h>

#include <array>
#include <optional>
#include <string>

namespace isocast {

/// Scaled, then turned about an axis through the origin (right-handed), then shifted; or a matrix instead.
struct Placement {
  Double3 scale = {1, 1, 1}, axis = {0, 0, 1}, shift = {0, 0, 0};
  double degrees = 0;
  std::optional<Transform> matrix;
};

/// Throws InputError when it has no inverse: a scale of zero, an axis without length, rows in one plane.
[[nodiscard]] Transform transform_of(const Placement& placement);

/// The solid a x + b y + c z + d <= 0 as a formula.
[[nodiscard]] std::string plane_formula(const std::array<double, 4>& plane);
/// The box between two corners as a formula that is not positive in it.
[[nodiscard]] std::string box_formula(const Double3& a, const Double3& b);

}  // namespace isocast
