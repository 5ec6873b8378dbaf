// The sRGB transfer function (IEC 61966-2-1).
#pragma once

#include <cmath>

namespace isocast {

/// The linear value of a code, both in [0, 1].
[[nodiscard]] inline double linear_from_srgb(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

}  // namespace isocast
