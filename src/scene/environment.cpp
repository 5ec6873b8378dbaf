#include <isocast/math/elementary.h>
#include <isocast/scene/environment.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

// The place of a value between two pixels of a row or column; NaN becomes `lo`.
struct Place {
  int pixel;
  float part;
};
Place place(double x, double lo, double hi) {
  x = std::min(std::max(lo, x), hi);
  const double pixel = std::floor(x);
  return {static_cast<int>(pixel), static_cast<float>(x - pixel)};
}

}  // namespace

Environment::Environment(int width, int height, std::vector<Color> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {}

Color Environment::towards(const Double3& d) const {
  const double across = atan2(d[0], d[1]) / (2 * std::numbers::pi) + 0.5;
  const double down = atan2(std::sqrt(d[0] * d[0] + d[1] * d[1]), d[2]) / std::numbers::pi;
  // pixel centres at +0.5; the columns go around, the rows end at the poles
  const Place x = place(across * width_ - 0.5, -0.5, width_ - 0.5),
              y = place(down * height_ - 0.5, 0, height_ - 1);
  const int left = (x.pixel + width_) % width_, right = (left + 1) % width_;
  const Color *const row = &pixels_[std::size_t(y.pixel) * width_],
                     *const next = &pixels_[std::size_t(std::min(y.pixel + 1, height_ - 1)) * width_];
  Color color;
  for (int c = 0; c < 3; ++c)
    color[c] = (1 - y.part) * ((1 - x.part) * row[left][c] + x.part * row[right][c]) +
               y.part * ((1 - x.part) * next[left][c] + x.part * next[right][c]);
  return color;
}

}  // namespace isocast
