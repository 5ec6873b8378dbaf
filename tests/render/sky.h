// An environment that tests know in closed form.
#pragma once

#include <isocast/scene/environment.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace isocast::test {

/// A sky whose colour is the direction.
inline Color sky_towards(const Double3& d) {
  const Double3 n = normalized(d);
  return {static_cast<float>(0.5 + 0.5 * n[0]), static_cast<float>(0.5 + 0.5 * n[1]),
          static_cast<float>(0.5 + 0.5 * n[2])};
}
inline std::shared_ptr<const Environment> make_sky(int width = 128, int height = 64) {
  std::vector<Color> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double longitude = ((x + 0.5) / width - 0.5) * 2 * std::numbers::pi,
                   angle = (y + 0.5) / height * std::numbers::pi;
      pixels.push_back(sky_towards(
          {std::sin(longitude) * std::sin(angle), std::cos(longitude) * std::sin(angle), std::cos(angle)}));
    }
  return std::make_shared<Environment>(width, height, std::move(pixels));
}

}  // namespace isocast::test
