// Light from far away: a picture of all directions.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/scene/material.h>

#include <vector>

namespace isocast {

/// Longitude by latitude, z up, seen from within: the top row faces +z, the middle column +y, and +x lies to
/// the right of it.
class Environment {
 public:
  /// pixels  linear RGB, finite, row-major from the top; width * height of them, at least one
  Environment(int width, int height, std::vector<Color> pixels);

  /// The colour that a ray of this direction (any length) ends in, interpolated between four pixels. The same
  /// bits on every processor; a NaN counts as some direction.
  [[nodiscard]] Color towards(const Double3& direction) const;

 private:
  int width_, height_;
  std::vector<Color> pixels_;
};

}  // namespace isocast
