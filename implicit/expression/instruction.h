// The operations of formulas and the plain data of a tape, as they cross into kernels.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

/// Grouped by what they read: nothing, one operand, two operands, three.
enum class Op : std::uint8_t {
  // clang-format off
  constant, variable,
  negate, abs, sign, square, power, chebyshev, sqrt, cbrt, exp, log, log10, sin, cos, tan, asin, acos, atan,
  sinh, cosh, tanh, floor, ceil, round,
  add, subtract, multiply, divide, min, max, pow, atan2, step,
  choose
  // clang-format on
};

[[nodiscard]] constexpr int operand_count(Op op) {
  return op <= Op::variable ? 0 : op < Op::add ? 1 : op < Op::choose ? 2 : 3;
}

/// out = op(a, b, c), all of them registers. `constant` reads constants[a], `variable` reads input a (0..3
/// for x y z w), `power` raises a to the integer n, `chebyshev` is the polynomial of degree n at a, `choose`
/// is b where a is not 0, else c.
struct Instruction {
  Op op;
  std::uint32_t out, a, b, c;
  std::int32_t n;
};

/// The double nearest to a constant of the formula; `exact` when it is that constant, else off by at most
/// half an ulp.
struct TapeConstant {
  double value;
  bool exact;
};

/// A tape as pointers, for as long as its owner lives.
struct TapeView {
  const Instruction* code;
  std::size_t length;
  const TapeConstant* constants;
  std::uint32_t result;
};

}  // namespace isocast
