#include <fmt/format.h>
#include <isocast/apps/scene_build/placement.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

// Rodrigues' formula; quarter turns are exact.
Transform rotation(const Double3& axis, double degrees) {
  const Double3 u = normalized(axis);
  const double quarters = degrees / 90;
  double s = std::sin(degrees * std::numbers::pi / 180), c = std::cos(degrees * std::numbers::pi / 180);
  if (quarters == std::floor(quarters)) s = std::round(s), c = std::round(c);
  Transform t;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const int other = 3 - row - column;
      double turn = 0;
      if (row != column) turn = (column == (row + 1) % 3 ? -1 : 1) * s * u[other];
      t.m[row][column] = (1 - c) * u[row] * u[column] + turn + (row == column ? c : 0);
    }
  return t;
}

Transform composed(const Placement& p) {
  if (p.matrix) return *p.matrix;
  Transform scale;
  for (int a = 0; a < 3; ++a) scale.m[a][a] = p.scale[a];
  Transform t = rotation(p.axis, p.degrees) * scale;
  for (int a = 0; a < 3; ++a) t.m[a][3] = p.shift[a];
  return t;
}

}  // namespace

Transform transform_of(const Placement& placement) {
  const double axis = length(placement.axis);
  if (!(axis > 0 && axis < 1e150))
    throw InputError("found a rotation without an axis, expected [x, y, z, degrees]");
  const Transform t = composed(placement);
  double product = 1;
  for (int c = 0; c < 3; ++c) product *= length({t.m[0][c], t.m[1][c], t.m[2][c]});
  const bool finite = std::ranges::all_of(t.m, [](const auto& row) {
    return std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
  });
  constexpr double kFlat = 1e-12;
  if (!finite || !std::isnormal(product) || !std::isnormal(t.determinant()) ||
      !(std::abs(t.determinant()) > kFlat * product))
    throw InputError(
        "the transform has no inverse in double precision, expected axes of some length that span space");
  return t;
}

std::string plane_formula(const std::array<double, 4>& plane) {
  return fmt::format("({})*x+({})*y+({})*z+({})", plane[0], plane[1], plane[2], plane[3]);
}

std::string box_formula(const Double3& a, const Double3& b) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis];
    const double lo = std::min(a[axis], b[axis]), hi = std::max(a[axis], b[axis]);
    const std::string slab = fmt::format("max({}-({}),({})-{})", name, hi, lo, name);
    text = text.empty() ? slab : fmt::format("max({},{})", text, slab);
  }
  return text;
}

}  // namespace isocast
