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

// The degree of a node from those of its operands; nothing where it is no polynomial.
std::optional<std::int64_t> degree_of(const Node& node, const std::vector<std::int64_t>& of) {
  const std::int64_t a = of[node.a], b = of[node.b];
  switch (node.op) {
    case Op::constant: return 0;
    case Op::variable: return node.a < 3 ? 1 : 0;
    case Op::negate: return a;
    case Op::square: return 2 * a;
    case Op::add:
    case Op::subtract: return std::max(a, b);
    case Op::multiply: return a + b;
    case Op::chebyshev: return node.n * a;
    case Op::power:
      if (node.n >= 0 || a == 0) return std::max(0, node.n) * a;
      return std::nullopt;
    case Op::divide:
      if (b == 0) return a;
      return std::nullopt;
    default: {
      const int operands = operand_count(node.op);
      const std::int64_t most = std::max({a, operands > 1 ? b : 0, operands > 2 ? of[node.c] : 0});
      if (most == 0) return 0;
      return std::nullopt;
    }
  }
}

}  // namespace

PolynomialDegree polynomial_degree(const Expression& as_written) {
  const Expression expression = simplify(as_written);
  // operands come first; what the root does not need does not count
  const std::vector<Node>& nodes = expression.nodes();
  std::vector<bool> needed(nodes.size(), false);
  needed[expression.root()] = true;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const int operands = operand_count(nodes[i].op);
    if (operands > 0) needed[nodes[i].a] = true;
    if (operands > 1) needed[nodes[i].b] = true;
    if (operands > 2) needed[nodes[i].c] = true;
  }
  std::vector<std::int64_t> of(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!needed[i]) continue;
    const auto degree = degree_of(nodes[i], of);
    if (!degree) return {std::nullopt, fmt::format("not a polynomial because of {}", name_of(nodes[i].op))};
    if (*degree > kMostPolynomialDegree)
      return {std::nullopt, fmt::format("not treated as a polynomial because its degree may be above {}",
                                        kMostPolynomialDegree)};
    of[i] = *degree;
  }
  return {static_cast<int>(of[expression.root()]), {}};
}

}  // namespace isocast
