// A tile of the picture as a solid: four planes that hold all its primary rays.
#pragma once

#include <isocast/math/box.h>

namespace isocast {

/// Plane i holds the points p with dot(normal[i], p) >= offset[i]; all points of the tile's rays with t >= 0
/// satisfy the four.
struct TileFrustum {
  Double3 normal[4];
  double offset[4];

  /// False only when the box lies wholly behind one plane.
  [[nodiscard]] bool may_meet(const Box& box) const {
    for (int i = 0; i < 4; ++i) {
      double largest = 0, scale = 0;
      for (int a = 0; a < 3; ++a) {
        largest += normal[i][a] * (normal[i][a] > 0 ? box.hi[a] : box.lo[a]);
        scale += std::abs(normal[i][a]) * std::max(std::abs(box.lo[a]), std::abs(box.hi[a]));
      }
      if (largest < offset[i] - 0x1p-40 * (scale + std::abs(offset[i]))) return false;
    }
    return true;
  }
};

}  // namespace isocast
