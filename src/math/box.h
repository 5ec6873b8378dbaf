// Axis-aligned boxes of the world.
#pragma once

#include <isocast/math/transform.h>

#include <algorithm>
#include <limits>

namespace isocast {

/// [lo, hi] per axis; empty (lo > hi) by default.
struct Box {
  Double3 lo = {inf, inf, inf}, hi = {-inf, -inf, -inf};
  static constexpr double inf = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1] && lo[2] <= hi[2]); }
  [[nodiscard]] Double3 center() const { return 0.5 * (lo + hi); }
  [[nodiscard]] double diagonal() const { return length(hi - lo); }
  void add(const Double3& p) {
    for (int a = 0; a < 3; ++a) {
      lo[a] = std::min(lo[a], p[a]);
      hi[a] = std::max(hi[a], p[a]);
    }
  }
  void add(const Box& b) {
    if (b.empty()) return;
    add(b.lo);
    add(b.hi);
  }
  /// Corner 0...7: bit a chooses hi on axis a.
  [[nodiscard]] Double3 corner(int i) const {
    return {i & 1 ? hi[0] : lo[0], i & 2 ? hi[1] : lo[1], i & 4 ? hi[2] : lo[2]};
  }
};

}  // namespace isocast
