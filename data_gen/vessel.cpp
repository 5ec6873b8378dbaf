#include <isocast/data_gen/hash.h>
#include <isocast/data_gen/vessel.h>
#include <isocast/math/transform.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace isocast {
namespace {

// A piece of tube whose radius falls from r0 at `from` to r1 at `to`.
struct Tube {
  Double3 from, to;
  double r0, r1;
};

// Two unit vectors that are perpendicular to each other and to the unit vector `axis`.
std::array<Double3, 2> perpendiculars(const Double3& axis) {
  const Double3 other = std::abs(axis[0]) < 0.5 ? Double3{1, 0, 0} : Double3{0, 1, 0};
  const Double3 first = normalized(cross(axis, other));
  return {first, cross(axis, first)};
}

// Adds the branch that leaves `from`, and what it forks into; `id` names the branch to the random numbers.
void grow(std::vector<Tube>& tubes, std::uint64_t seed, std::uint64_t id, const Double3& from,
          const Double3& direction, double length, double radius, int levels) {
  const double child_radius = radius * std::cbrt(0.5);
  const Double3 to = from + length * direction;
  tubes.push_back({from, to, radius, child_radius});
  if (levels == 0) return;

  // both children lean away from the branch, to opposite sides
  const auto [u, v] = perpendiculars(direction);
  const double turn = 2 * std::numbers::pi * hash_uniform({seed, id, 0});
  const Double3 side = std::cos(turn) * u + std::sin(turn) * v;
  for (const std::uint64_t child : {0, 1}) {
    const double angle = 0.35 + 0.45 * hash_uniform({seed, id, 1 + child});
    const Double3 lean = (child == 0 ? std::sin(angle) : -std::sin(angle)) * side;
    const double child_length = length * (0.7 + 0.2 * hash_uniform({seed, id, 3 + child}));
    grow(tubes, seed, 2 * id + child, to, std::cos(angle) * direction + lean, child_length, child_radius,
         levels - 1);
  }
}

// 1 on the tube's axis, falling linearly to 0 at two radii.
double profile(const Tube& tube, const Double3& p) {
  const Double3 axis = tube.to - tube.from, offset = p - tube.from;
  const double along = std::clamp(dot(offset, axis) / dot(axis, axis), 0.0, 1.0);
  const double radius = tube.r0 + along * (tube.r1 - tube.r0);
  return std::max(0.0, 1 - length(offset - along * axis) / (2 * radius));
}

// Whether the tube has values above 0 between the planes p[axis] = lo and hi.
bool reaches(const Tube& tube, int axis, double lo, double hi) {
  const double reach = 2 * tube.r0;
  return std::min(tube.from[axis], tube.to[axis]) - reach <= hi &&
         std::max(tube.from[axis], tube.to[axis]) + reach >= lo;
}

}  // namespace

Field vessel_field(std::uint64_t seed, int levels) {
  std::vector<Tube> tubes;
  grow(tubes, seed, 1, {0, 0, -1}, {0, 0, 1}, 0.55, 0.11, levels);
  return [tubes = std::move(tubes)](const SampleGrid& grid, std::int64_t j, std::int64_t k,
                                    std::span<double> values) {
    const double y = grid.position(1, j), z = grid.position(2, k);
    std::ranges::fill(values, 0.0);
    for (const Tube& tube : tubes) {
      if (!reaches(tube, 1, y, y) || !reaches(tube, 2, z, z)) continue;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = grid.position(0, static_cast<std::int64_t>(i));
        values[i] = std::max(values[i], profile(tube, {x, y, z}));
      }
    }
  };
}

}  // namespace isocast
