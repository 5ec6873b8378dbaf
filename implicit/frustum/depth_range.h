// The depths at which a part of the picture sees a box.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/pixel_lines.h>

#include <optional>

namespace isocast {

/// Least and largest depth s >= 0 at which a ray through pixel positions [u0, u1] x [v0, v1] is in the box,
/// with room for roundings; nothing where none is.
struct DepthRange {
  double near, far;
};
[[nodiscard]] std::optional<DepthRange> depth_range(const PixelLines& lines, double u0, double u1, double v0,
                                                    double v1, const Box& box);

}  // namespace isocast
