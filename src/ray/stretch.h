// Rays that follow a surface in doubt.
#pragma once

#include <isocast/ray/hit.h>

#include <algorithm>

namespace isocast {

/// A part of one ray along which crossing after crossing is undecided, but for some between them. Such a ray
/// leaps on after a while, each time as far as the stretch is long: it comes to its end in few steps,
/// whatever roundings make of the surface there.
class Stretch {
 public:
  /// Takes note of a crossing that the ray goes on behind; true where it is to leap.
  bool leaps_behind(const HitStream& hits, int i) {
    if (hits.certificate[i] != Certificate::undecided) {
      count_ = std::max(count_ - 1, 0);
      return false;
    }
    if (count_ == 0) begin_ = hits.t_lo[i];
    count_ = std::min(count_ + 2, kMost);
    return count_ > kPatience;
  }
  /// How far a leap from behind the crossing leads.
  [[nodiscard]] double length(const HitStream& hits, int i) const { return hits.t_hi[i] - begin_; }

 private:
  static constexpr int kPatience = 8, kMost = 12;
  double begin_ = 0;
  int count_ = 0;
};

}  // namespace isocast
