#include <isocast/apps/reference/formula_polynomial.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace isocast::reference {
namespace {

// Numbers of like size in o, d and the range of t make coordinates of about so many bits.
constexpr double kAxisBits = 300;
constexpr double kMaxWork = 1e9;

// Degree in s and a bound on the bits of a coefficient's numerator and denominator together.
struct Size {
  double degree = 0, bits = 0;
};

// The whole number that a constant node is, if it is a small one.
std::optional<int> whole_number(const ExactFormula& formula, NodeId id) {
  const Node& node = formula.nodes[id];
  if (node.op != Op::constant || !formula.constants[node.a].name.empty()) return std::nullopt;
  const fmpq* const value = formula.constants[node.a].value.get();
  if (!fmpz_is_one(fmpq_denref(value)) || fmpz_bits(fmpq_numref(value)) > 16) return std::nullopt;
  return static_cast<int>(fmpz_get_si(fmpq_numref(value)));
}

std::optional<Size> size_of(const ExactFormula& formula, const Node& node, const std::vector<Size>& sizes) {
  const Size none, &a = operand_count(node.op) > 0 ? sizes[node.a] : none,
                   &b = operand_count(node.op) > 1 ? sizes[node.b] : none;
  const auto raised = [&](int n) -> std::optional<Size> {
    if (n < 0) return std::nullopt;
    return Size{a.degree * n, (a.bits + std::log2(a.degree + 1) + 1) * n};
  };
  switch (node.op) {
    case Op::constant: {
      const ExactConstant& constant = formula.constants[node.a];
      if (!constant.name.empty()) return std::nullopt;
      return Size{0, static_cast<double>(fmpz_bits(fmpq_numref(constant.value.get())) +
                                         fmpz_bits(fmpq_denref(constant.value.get())))};
    }
    case Op::variable: return Size{1, kAxisBits};
    case Op::negate: return a;
    case Op::square: return raised(2);
    case Op::power: return raised(node.n);
    case Op::chebyshev: return raised(2 * node.n);
    case Op::pow: {
      const std::optional<int> n = whole_number(formula, node.b);
      return n ? raised(*n) : std::nullopt;
    }
    case Op::add:
    case Op::subtract: return Size{std::max(a.degree, b.degree), std::max(a.bits, b.bits) + 1};
    case Op::multiply: return Size{a.degree + b.degree, a.bits + b.bits + std::log2(a.degree + 1)};
    case Op::divide: {
      const Node& divisor = formula.nodes[node.b];
      const bool number = divisor.op == Op::constant && formula.constants[divisor.a].name.empty() &&
                          !fmpq_is_zero(formula.constants[divisor.a].value.get());
      return number ? std::optional(Size{a.degree, a.bits + b.bits}) : std::nullopt;
    }
    default: return std::nullopt;
  }
}

void evaluate(const ExactFormula& formula, const Node& node, const std::array<RationalAxis, 3>& axes,
              std::vector<RationalPolynomial>& values) {
  RationalPolynomial result;
  fmpq_poly_struct* const y = result.set();
  const auto operand = [&](NodeId id) { return values[id].get(); };
  switch (node.op) {
    case Op::constant: fmpq_poly_set_fmpq(y, formula.constants[node.a].value.get()); break;
    case Op::variable:
      fmpq_poly_set_coeff_fmpq(y, 0, axes[node.a].start.get());
      fmpq_poly_set_coeff_fmpq(y, 1, axes[node.a].span.get());
      break;
    case Op::negate: fmpq_poly_neg(y, operand(node.a)); break;
    case Op::square: fmpq_poly_mul(y, operand(node.a), operand(node.a)); break;
    case Op::power: fmpq_poly_pow(y, operand(node.a), static_cast<ulong>(node.n)); break;
    case Op::pow:
      fmpq_poly_pow(y, operand(node.a), static_cast<ulong>(whole_number(formula, node.b).value()));
      break;
    case Op::chebyshev: {
      RationalPolynomial chebyshev;
      WholePolynomial whole;
      fmpz_poly_chebyshev_t(whole.set(), static_cast<ulong>(node.n));
      fmpq_poly_set_fmpz_poly(chebyshev.set(), whole.get());
      fmpq_poly_compose(y, chebyshev.get(), operand(node.a));
      break;
    }
    case Op::add: fmpq_poly_add(y, operand(node.a), operand(node.b)); break;
    case Op::subtract: fmpq_poly_sub(y, operand(node.a), operand(node.b)); break;
    case Op::multiply: fmpq_poly_mul(y, operand(node.a), operand(node.b)); break;
    default: fmpq_poly_div(y, operand(node.a), operand(node.b)); break;
  }
  values.push_back(std::move(result));
}

}  // namespace

bool is_polynomial(const ExactFormula& formula) {
  std::vector<Size> sizes;
  double work = 0;
  for (const Node& node : formula.nodes) {
    const std::optional<Size> size = size_of(formula, node, sizes);
    if (!size || size->degree > kMaxExactDegree) return false;
    work += (size->degree + 1) * (size->bits + 100);
    if (!(work <= kMaxWork)) return false;
    sizes.push_back(*size);
  }
  return true;
}

WholePolynomial polynomial_along(const ExactFormula& formula, const std::array<RationalAxis, 3>& axes) {
  std::vector<RationalPolynomial> values;
  values.reserve(formula.nodes.size());
  for (const Node& node : formula.nodes) evaluate(formula, node, axes, values);
  WholePolynomial whole;
  fmpq_poly_get_numerator(whole.set(), values.back().get());
  return whole;
}

}  // namespace isocast::reference
