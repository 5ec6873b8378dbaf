// Two pictures with layers, number by number.
#pragma once

#include <isocast/render/image_file.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isocast {

struct PixelDifference {
  int x, y;
  double difference;
};

/// Differences of one layer over the pixels that count: of the colour (the largest of R G B A, linear) all,
/// of cost and certificate all, else those that are hit in both pictures. id and object: 1 where they differ.
/// +inf where one of two numbers is NaN.
///
/// decides   the tolerance holds for it: not for cost and certificate, which are the methods' own
/// largest   what the tolerance is for: max, of normals in radians
/// worst     the largest differences, at most ten; none that is zero
/// by_pixel  rows from the top; zero where the layer does not count
struct LayerDifference {
  std::string name, unit;
  bool decides = true;
  std::int64_t pixels = 0;
  double p50 = 0, p90 = 0, p99 = 0, max = 0, largest = 0;
  std::vector<PixelDifference> worst;
  std::vector<double> by_pixel;
};

/// Pixels that are hit.
///
/// by     the layer that tells: depth or z where it is finite, id where it is not 0, else A
/// first  the first pixels that differ, at most ten; their difference means nothing
struct MaskDifference {
  std::string by;
  std::int64_t both = 0, only_a = 0, only_b = 0, neither = 0;
  std::vector<PixelDifference> first;
  std::vector<std::array<bool, 2>> by_pixel;
};

/// The layers that both pictures have, under either of their names (ChannelNames).
///
/// only_a, only_b  the names of those that one has alone
struct Comparison {
  int width, height;
  MaskDifference mask;
  std::vector<LayerDifference> layers;
  std::vector<std::string> only_a = {}, only_b = {};

  /// The same pixels are hit, and nothing differs by more.
  [[nodiscard]] bool within(double tolerance) const;
};

/// Throws InputError for different sizes, and where there is no layer to compare.
[[nodiscard]] Comparison compare_images(const Image& a, const Image& b);

/// RGBA, linear: red and blue where only a or only b is hit; else grey by the first layer, from black (same)
/// over four decades to white (its largest difference).
[[nodiscard]] std::vector<float> difference_picture(const Comparison& comparison);

}  // namespace isocast
