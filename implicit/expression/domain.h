// The box in which a formula is looked at.
#pragma once

#include <array>

namespace isocast {

/// lo and hi of x, y and z, in world units.
struct Domain {
  std::array<double, 3> lo = {-1, -1, -1}, hi = {1, 1, 1};
};

}  // namespace isocast
