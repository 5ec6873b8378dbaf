// Colours, and how surfaces use them.
#pragma once

#include <array>

namespace isocast {

/// Linear RGB.
using Color = std::array<float, 3>;

/// How an iso-surface looks.
///
/// opacity       share of the light from behind that it keeps out, 0 to 1
/// reflectivity  share of its colour that comes from the mirrored ray, 0 to 1
/// specular      strength of the white highlight, 0 to 1
struct Material {
  Color color = {1, 1, 1};
  float opacity = 1, reflectivity = 0, specular = 0.12f;
};

}  // namespace isocast
