#include <fmt/format.h>
#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/expression/simplify.h>

#include <algorithm>
#include <vector>

namespace isocast {
namespace {

const char* name_of(Op op) {
  static constexpr const char* names[] = {"a number",
                                          "a variable",
                                          "negation",
                                          "abs",
                                          "sign",
                                          "a square",
                                          "a power",
                                          "a Chebyshev polynomial",
                                          "sqrt",
                                          "cbrt",
                                          "exp",
                                          "log",
                                          "log10",
                                          "sin",
                                          "cos",
                                          "tan",
                                          "asin",
                                          "acos",
                                          "atan",
                                          "sinh",
                                          "cosh",
                                          "tanh",
                                          "floor",
                                          "ceil",
                                          "round",
                                          "a sum",
                                          "a difference",
                                          "a product",
                                          "a division by what depends on x, y or z",
                                          "min",
                                          "max",
                                          "a power that is no whole number",
                                          "atan2",
                                          "a comparison",
                                          "if"};
  return names[static_cast<std::size_t>(op)];
}

// The degree of a result from those in the registers; nothing where it is no polynomial.
std::optional<std::int64_t> degree_of(const Instruction& i, const std::vector<std::int64_t>& of) {
  const int operands = operand_count(i.op);
  const std::int64_t a = operands > 0 ? of[i.a] : 0, b = operands > 1 ? of[i.b] : 0,
                     c = operands > 2 ? of[i.c] : 0;
  switch (i.op) {
    case Op::constant: return 0;
    case Op::variable: return i.a < 3 ? 1 : 0;
    case Op::negate: return a;
    case Op::square: return 2 * a;
    case Op::add:
    case Op::subtract: return std::max(a, b);
    case Op::multiply: return a + b;
    case Op::chebyshev: return i.n * a;
    case Op::power:
      if (i.n >= 0 || a == 0) return std::max(0, i.n) * a;
      return std::nullopt;
    case Op::divide:
      if (b == 0) return a;
      return std::nullopt;
    default:
      if (std::max({a, b, c}) == 0) return 0;
      return std::nullopt;
  }
}

}  // namespace

PolynomialDegree polynomial_degree(const Tape& tape) {
  std::vector<std::int64_t> of(tape.registers, 0);
  for (const Instruction& i : tape.code) {
    const auto degree = degree_of(i, of);
    if (!degree) return {std::nullopt, fmt::format("not a polynomial because of {}", name_of(i.op))};
    if (*degree > kMostPolynomialDegree)
      return {std::nullopt, fmt::format("not treated as a polynomial because its degree may be above {}",
                                        kMostPolynomialDegree)};
    of[i.out] = *degree;
  }
  return {static_cast<int>(of[tape.result]), {}};
}

PolynomialDegree polynomial_degree(const Expression& expression) {
  return polynomial_degree(make_tape(simplify(expression)));
}

}  // namespace isocast
