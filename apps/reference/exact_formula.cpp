#include <isocast/apps/reference/exact_formula.h>

#include <charconv>
#include <cstdlib>

namespace isocast::reference {
namespace {

ExactConstant exact_constant_of(const Constant& constant) {
  ExactConstant exact;
  const std::size_t e = constant.text.find('e', 1);
  if (e == std::string::npos) {
    exact.name = constant.text;
    return exact;
  }
  // digits * 10^exponent
  slong exponent = 0;
  std::from_chars(constant.text.data() + e + 1, constant.text.data() + constant.text.size(), exponent);
  fmpz* const numerator = fmpq_numref(exact.value.set());
  fmpz_set_str(numerator, constant.text.substr(0, e).c_str(), 10);
  Rational power;
  fmpz* const scale = fmpq_numref(power.set());
  fmpz_set_ui(scale, 10);
  fmpz_pow_ui(scale, scale, static_cast<ulong>(std::abs(exponent)));
  if (exponent >= 0) fmpz_mul(numerator, numerator, scale);
  else fmpq_div_fmpz(exact.value.set(), exact.value.get(), scale);
  return exact;
}

// Nodes that the root needs.
std::vector<bool> needed(const Expression& expression) {
  std::vector<bool> marks(expression.nodes().size());
  marks[expression.root()] = true;
  for (NodeId id = expression.root() + 1; id-- > 0;) {
    const Node& node = expression.node(id);
    if (!marks[id]) continue;
    const int count = operand_count(node.op);
    if (count > 0) marks[node.a] = true;
    if (count > 1) marks[node.b] = true;
    if (count > 2) marks[node.c] = true;
  }
  return marks;
}

}  // namespace

Ball ball_of(const ExactConstant& constant, slong bits) {
  Ball ball;
  if (constant.name == "pi") arb_const_pi(ball.set(), bits);
  else if (constant.name == "e") arb_const_e(ball.set(), bits);
  else if (constant.name.empty()) arb_set_fmpq(ball.set(), constant.value.get(), bits);
  else {
    // phi = (1 + sqrt(5)) / 2
    arb_sqrt_ui(ball.set(), 5, bits);
    arb_add_ui(ball.set(), ball.get(), 1, bits);
    arb_mul_2exp_si(ball.set(), ball.get(), -1);
  }
  return ball;
}

ExactFormula exact_formula(const Expression& expression, double iso, double time) {
  ExactFormula formula;
  const auto number = [&](const Constant& constant) {
    formula.constants.push_back(exact_constant_of(constant));
    formula.nodes.push_back({Op::constant, static_cast<NodeId>(formula.constants.size() - 1)});
    return static_cast<NodeId>(formula.nodes.size() - 1);
  };
  const std::vector<bool> marks = needed(expression);
  std::vector<NodeId> place(marks.size());
  for (NodeId id = 0; id <= expression.root(); ++id) {
    if (!marks[id]) continue;
    Node node = expression.node(id);
    if (node.op == Op::constant) place[id] = number(expression.constant_at(id));
    else if (node.op == Op::variable && node.a == 3) place[id] = number(exact_constant(time));
    else {
      const int count = operand_count(node.op);
      if (count > 0) node.a = place[node.a];
      if (count > 1) node.b = place[node.b];
      if (count > 2) node.c = place[node.c];
      place[id] = static_cast<NodeId>(formula.nodes.size());
      formula.nodes.push_back(node);
    }
  }
  const NodeId value = place[expression.root()], level = number(exact_constant(iso));
  formula.nodes.push_back({Op::subtract, value, level});
  return formula;
}

}  // namespace isocast::reference
