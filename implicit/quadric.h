// Where rays lie in half spaces, balls and other solids of degree 2.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/math/interval.h>
#include <isocast/math/transform.h>

#include <optional>

namespace isocast {

/// The part lo <= t <= hi of a line; empty where not lo <= hi.
struct LinePart {
  double lo, hi;
};

/// g = c + l p + p^T q p, with coefficients that are known up to roundings.
class Quadric {
 public:
  /// Nothing where g (with w = time) is no polynomial of degree 2 or less, or too large for numbers.
  static std::optional<Quadric> of(const Tape& g, double time);

  /// A part of the line o + t d outside of which g > 0 for sure; the whole line where that may be two parts.
  /// A finite end lies a little outside: 2^-40 of its size.
  [[nodiscard]] LinePart inside(const Double3& o, const Double3& d) const;

 private:
  using I = Interval<double>;

  bool flat_ = false;     // of degree 1: q is 0
  I c_, l_[3], q_[3][3];  // q: upper triangle
};

}  // namespace isocast
