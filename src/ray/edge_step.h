// From a pixel where a surface is hit to a neighbour where it is not, or further away.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

/// u, v    position of the hit's ray, in pixels; du, dv: the way to the neighbour's
/// depth   of the hit, along the view axis (PixelLines' s)
/// iso     the iso-value that is hit
struct EdgeStep {
  double u, v, du, dv, depth;
  std::uint8_t iso;
};

/// What an edge that is not found has for a share.
inline constexpr float kNoEdge = -1;

}  // namespace isocast
