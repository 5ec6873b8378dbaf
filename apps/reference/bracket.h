// A root between two points, brought closer.
#pragma once

#include <isocast/apps/reference/ball.h>

#include <functional>

namespace isocast::reference {

/// A function at an exact s: a ball of one sign, an exact zero, or one that says nothing where even much
/// precision does not decide.
using ValueAt = std::function<Ball(const Ball& s)>;

/// Exact points lo <= hi.
struct Bracket {
  Ball lo, hi;
};
[[nodiscard]] Ball between(const Ball& lo, const Ball& hi, double part);
/// hi - lo <= width.
[[nodiscard]] bool is_within(const Ball& lo, const Ball& hi, double width);

/// Narrows the bracket of the only root of a continuous function, which has opposite signs just inside its
/// ends, to `width`, or as far as signs are known. f_lo and f_hi are the values there, in sign at least.
/// source  Abbott: Quadratic interval refinement for real roots, 2006
[[nodiscard]] Bracket refine(const ValueAt& value_at, Bracket root, Ball f_lo, Ball f_hi, double width);

}  // namespace isocast::reference
