// Planes that cut, as the formulas of --clip.
#pragma once

#include <isocast/math/box.h>

#include <string>
#include <vector>

namespace isocast::viewer {

/// Keeps what lies below `place` along an axis, or above it; a share of the scene's bounds, 0 to 1.
struct ClipPlane {
  int axis = 0;
  double place = 0.5;
  bool above = false, on = true;
};

/// One formula for each plane that is on.
[[nodiscard]] std::vector<std::string> clip_formulas(const std::vector<ClipPlane>& planes, const Box& bounds);

}  // namespace isocast::viewer
