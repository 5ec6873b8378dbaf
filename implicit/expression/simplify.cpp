#include <isocast/implicit/expression/polynomial.h>
#include <isocast/implicit/expression/simplify.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <unordered_set>
#include <utility>

namespace isocast {
namespace {

// The error of a product or a quotient, found by fma, is itself exact only away from underflow.
constexpr double kTiny = 0x1p-900;
bool fits(double result) { return std::isfinite(result) && std::abs(result) >= kTiny; }

std::optional<double> exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  const double error = (a - (sum - part)) + (b - part);
  return std::isfinite(sum) && error == 0 ? std::optional(sum) : std::nullopt;
}

std::optional<double> exact_product(double a, double b) {
  if (a == 0 || b == 0) return a * b;
  const double product = a * b;
  return fits(product) && std::fma(a, b, -product) == 0 ? std::optional(product) : std::nullopt;
}

std::optional<double> exact_quotient(double a, double b) {
  if (b == 0) return std::nullopt;
  if (a == 0) return a / b;
  const double quotient = a / b;
  return fits(quotient) && fits(a) && std::fma(quotient, b, -a) == 0 ? std::optional(quotient) : std::nullopt;
}

std::optional<double> exact_root(double a) {
  if (a == 0) return a;
  const double root = std::sqrt(a);
  return fits(a) && fits(root) && std::fma(root, root, -a) == 0 ? std::optional(root) : std::nullopt;
}

std::optional<double> exact_power(double a, int n) {
  std::optional<double> product = 1;
  for (int i = 0; i < std::abs(n) && product; ++i) product = exact_product(*product, a);
  return product && n < 0 ? exact_quotient(1, *product) : product;
}

// The literal integer exponents that become repeated squaring.
std::optional<int> small_integer(double value) {
  if (std::abs(value) > kMaxPower || value != std::floor(value)) return std::nullopt;
  return static_cast<int>(value);
}

// op(a, b) when it is a number that double precision holds exactly.
std::optional<double> exact_value(Op op, double a, double b, int n) {
  switch (op) {
    case Op::negate: return -a;
    case Op::abs: return std::abs(a);
    case Op::sign: return double((a > 0) - (a < 0));
    case Op::square: return exact_product(a, a);
    case Op::power: return exact_power(a, n);
    case Op::sqrt: return exact_root(a);
    case Op::floor: return std::floor(a);
    case Op::ceil: return std::ceil(a);
    case Op::round: return std::round(a);
    case Op::add: return exact_sum(a, b);
    case Op::subtract: return exact_sum(a, -b);
    case Op::multiply: return exact_product(a, b);
    case Op::divide: return exact_quotient(a, b);
    case Op::min: return a < b ? a : b;
    case Op::max: return a > b ? a : b;
    case Op::step: return double(b >= a);
    case Op::pow: return small_integer(b) ? exact_power(a, *small_integer(b)) : std::nullopt;
    default: return std::nullopt;
  }
}

// Builds the simpler graph from operands that are simple already.
class Simplifier {
 public:
  NodeId build(const Node& node, NodeId a, NodeId b, NodeId c) {
    if (const std::optional<double> value = folded(node, a, b)) return number(*value);
    const NodeId id = rewritten(node, a, b, c);
    if (shows_truth(id)) truths_.insert(id);
    const std::optional<Polynomials::Chebyshev> found = polynomials_.as_chebyshev(id);
    return found ? out.chebyshev(found->base, found->degree) : id;
  }

  Expression out;

 private:
  NodeId rewritten(const Node& node, NodeId a, NodeId b, NodeId c) {
    switch (node.op) {
      case Op::negate: return out.node(a).op == Op::negate ? out.node(a).a : out.unary(Op::negate, a);
      case Op::abs:
      case Op::sign: return is_truth(a) ? a : out.unary(node.op, a);
      case Op::add: return sum(a, b);
      case Op::subtract: return difference(a, b);
      case Op::multiply: return product(a, b);
      case Op::divide: return quotient(a, b);
      case Op::pow: return raised(a, b);
      case Op::power: return power(a, node.n);
      case Op::chebyshev: return chebyshev(a, node.n);
      case Op::choose: return choice(a, b, c);
      default: return operand_count(node.op) == 1 ? out.unary(node.op, a) : out.binary(node.op, a, b);
    }
  }

  NodeId number(double value) { return out.constant(exact_constant(value)); }

  // The number at a node when double precision holds it exactly.
  std::optional<double> exact_number(NodeId id) const {
    if (out.node(id).op != Op::constant || !out.constant_at(id).exact) return std::nullopt;
    return out.constant_at(id).value;
  }
  bool is_number(NodeId id, double value) const { return exact_number(id) == std::optional(value); }

  // A result of -0 is left to be computed, since no literal spells it.
  std::optional<double> folded(const Node& node, NodeId a, NodeId b) const {
    const std::optional<double> left = exact_number(a);
    const std::optional<double> right = operand_count(node.op) == 2 ? exact_number(b) : left;
    if (!left || !right) return std::nullopt;
    const std::optional<double> value = exact_value(node.op, *left, *right, node.n);
    return value && (*value != 0 || !std::signbit(*value)) ? value : std::nullopt;
  }

  bool may_be_negative_zero(NodeId id) const {
    switch (out.node(id).op) {
      case Op::constant:
      case Op::abs:
      case Op::square:
      case Op::exp:
      case Op::cosh:
      case Op::acos: return false;
      case Op::power: return out.node(id).n % 2 != 0;
      default: return true;
    }
  }

  NodeId sum(NodeId a, NodeId b) {
    if (is_number(b, 0) && !may_be_negative_zero(a)) return a;
    if (is_number(a, 0) && !may_be_negative_zero(b)) return b;
    if (out.node(b).op == Op::negate) return difference(a, out.node(b).a);
    if (out.node(a).op == Op::negate) return difference(b, out.node(a).a);
    return out.binary(Op::add, std::min(a, b), std::max(a, b));
  }

  NodeId difference(NodeId a, NodeId b) {
    if (is_number(b, 0)) return a;
    if (is_number(a, 1) && is_opposite(b)) return out.node(b).b;
    if (out.node(b).op == Op::negate) return sum(a, out.node(b).a);
    return out.binary(Op::subtract, a, b);
  }

  NodeId product(NodeId a, NodeId b) {
    if (is_number(b, 1)) return a;
    if (is_number(a, 1)) return b;
    if (a == b) return out.unary(Op::square, a);
    return out.binary(Op::multiply, std::min(a, b), std::max(a, b));
  }

  // Only the reciprocals of powers of two are exact, and with them the quotient rounds as before.
  NodeId quotient(NodeId a, NodeId b) {
    const std::optional<double> divisor = exact_number(b);
    const std::optional<double> factor = divisor ? exact_quotient(1, *divisor) : std::nullopt;
    return factor ? product(a, number(*factor)) : out.binary(Op::divide, a, b);
  }

  NodeId raised(NodeId a, NodeId b) {
    const std::optional<double> exponent = exact_number(b);
    const std::optional<int> n = exponent ? small_integer(*exponent) : std::nullopt;
    return n ? power(a, *n) : out.binary(Op::pow, a, b);
  }

  NodeId power(NodeId a, int n) {
    if (n == 1) return a;
    return n == 2 ? out.unary(Op::square, a) : out.power(a, n);
  }

  // T_1(x) = x, T_m(T_n(x)) = T_mn(x)
  NodeId chebyshev(NodeId a, int n) {
    if (n == 1) return a;
    const Node& inner = out.node(a);
    if (inner.op == Op::chebyshev && n * inner.n <= kMaxChebyshevDegree)
      return out.chebyshev(inner.a, n * inner.n);
    return out.chebyshev(a, n);
  }

  NodeId choice(NodeId condition, NodeId a, NodeId b) {
    if (const std::optional<double> value = exact_number(condition)) return *value != 0 ? a : b;
    if (is_opposite(condition)) return choice(out.node(condition).b, b, a);
    const Node& node = out.node(condition);
    if (node.op == Op::sign && out.node(node.a).op == Op::abs) return out.choose(out.node(node.a).a, a, b);
    return out.choose(condition, a, b);
  }

  // Whether a node is 0, 1 or undefined for what it is made of, as comparisons, and, or and not are.
  bool shows_truth(NodeId id) const {
    const Node& node = out.node(id);
    switch (node.op) {
      case Op::step: return true;
      case Op::square: return is_truth(node.a);
      case Op::multiply: return is_truth(node.a) && is_truth(node.b);
      case Op::subtract: return is_number(node.a, 1) && is_truth(node.b);
      case Op::sign: {
        const Node& inner = out.node(node.a);
        return inner.op == Op::abs || (inner.op == Op::add && is_truth(inner.a) && is_truth(inner.b));
      }
      default: return false;
    }
  }
  bool is_truth(NodeId id) const { return truths_.contains(id); }
  // 1 - truth
  bool is_opposite(NodeId id) const { return out.node(id).op == Op::subtract && is_truth(id); }

  Polynomials polynomials_{out};
  std::unordered_set<NodeId> truths_;
};

}  // namespace

Expression simplify(const Expression& expression) {
  Simplifier simplifier;
  std::vector<NodeId> simple;
  simple.reserve(expression.nodes().size());
  for (const Node& node : expression.nodes()) {
    if (node.op == Op::constant) simple.push_back(simplifier.out.constant(expression.constants()[node.a]));
    else if (node.op == Op::variable) simple.push_back(simplifier.out.variable(static_cast<int>(node.a)));
    else simple.push_back(simplifier.build(node, simple[node.a], simple[node.b], simple[node.c]));
  }
  simplifier.out.set_root(simple[expression.root()]);
  return std::move(simplifier.out);
}

}  // namespace isocast
