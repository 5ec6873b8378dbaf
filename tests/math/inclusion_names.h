// The operations that inclusions have, as numbers that cross from one instruction set's build to another.
#pragma once

namespace isocast::test {

/// Grouped by their operands: one, then two.
enum class Inclusion {
  // clang-format off
  negate, abs, sign, square, power, chebyshev, sqrt, cbrt, exp, log, log10, sin, cos, tan, asin, acos, atan,
  sinh, cosh, tanh, floor, ceil, round,
  add, subtract, multiply, divide, min, max, pow, atan2, hypot, mod, step, choose
  // clang-format on
};
inline constexpr int kInclusionCount = static_cast<int>(Inclusion::choose) + 1;

}  // namespace isocast::test
