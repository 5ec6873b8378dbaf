#include <isocast/implicit/components.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/registers.h>
#include <isocast/math/elementary.h>

namespace isocast {
namespace {

// A choice nests as deep as the formula; deeper ends are one component.
constexpr int kMostParts = 1 << 16;

double evaluate_at(const Tape& tape, const double* inputs) {
  return evaluate(tape.view(), inputs, static_cast<double*>(registers_of(tape.registers * sizeof(double))));
}

Tape tape_of(Expression expression, NodeId node) {
  expression.set_root(node);
  return make_tape(simplify(expression));
}

}  // namespace

Components::Components(const Expression& expression) : root_(add(expression, expression.root(), false)) {}

int Components::add(const Expression& expression, NodeId node, bool is_condition) {
  const Node& n = expression.node(node);
  Part part{n.op};
  const bool inner = n.op == Op::min || n.op == Op::max || n.op == Op::negate || n.op == Op::choose;
  if (is_condition) {
    part.leaf = static_cast<int>(conditions_.size());
    conditions_.push_back(tape_of(expression, node));
  } else if (!inner || parts_.size() >= kMostParts) {
    part.op = Op::variable;
    part.leaf = static_cast<int>(leaves_.size());
    leaves_.push_back(tape_of(expression, node));
  } else if (n.op == Op::choose) {
    part.c = add(expression, n.a, true);
    part.a = add(expression, n.b, false);
    part.b = add(expression, n.c, false);
  } else {
    part.a = add(expression, n.a, false);
    if (n.op != Op::negate) part.b = add(expression, n.b, false);
  }
  parts_.push_back(part);
  return static_cast<int>(parts_.size()) - 1;
}

Components::Value Components::value(int index, const double* inputs) const {
  const Part& part = parts_[static_cast<std::size_t>(index)];
  switch (part.op) {
    case Op::negate: {
      const Value a = value(part.a, inputs);
      return {-a.f, a.leaf};
    }
    case Op::choose: {
      const auto& condition =
          conditions_[static_cast<std::size_t>(parts_[static_cast<std::size_t>(part.c)].leaf)];
      return value(evaluate_at(condition, inputs) != 0 ? part.a : part.b, inputs);
    }
    case Op::min:
    case Op::max: {
      const Value a = value(part.a, inputs), b = value(part.b, inputs);
      const bool second = part.op == Op::min ? b.f < a.f : b.f > a.f;
      return second ? b : a;
    }
    default: return {evaluate_at(leaves_[static_cast<std::size_t>(part.leaf)], inputs), part.leaf};
  }
}

int Components::at(const Double3& p, double time) const {
  if (count() == 1) return 0;
  const double inputs[4] = {p[0], p[1], p[2], time};
  return value(root_, inputs).leaf;
}

}  // namespace isocast
