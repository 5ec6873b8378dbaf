// From numbers to colours.
#pragma once

#include <isocast/scene/material.h>

#include <array>
#include <string>
#include <vector>

namespace isocast {

/// A colour of the map at x; sRGB, 0 to 1.
struct ColorPoint {
  double x;
  std::array<double, 3> srgb;
};

/// Colours along [0, 1], straight lines in sRGB between points; what lies outside has the colour of the end.
class ColorMap {
 public:
  /// points  by rising x, two or more, the first at 0 and the last at 1; two at the same x make a step
  /// nan     of NaN, linear
  explicit ColorMap(std::vector<ColorPoint> points, const Color& nan = {0.5f, 0.5f, 0.5f});

  /// Linear RGB.
  [[nodiscard]] Color at(double x) const;

 private:
  std::vector<ColorPoint> points_;
  Color nan_;
};

/// viridis, plasma, magma, inferno (Smith and van der Walt 2015), grey, or coolwarm (Moreland: Diverging
/// color maps for scientific visualization, ISVC 2009), each from a few of its points. Throws InputError with
/// the names for any other.
[[nodiscard]] ColorMap color_map_from_name(const std::string& name);
[[nodiscard]] std::vector<std::string> color_map_names();

}  // namespace isocast
