#include <isocast/implicit/components.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/math/elementary.h>

namespace isocast {
namespace {

double evaluate_at(const Tape& tape, const double* inputs) {
  return evaluate(tape.view(), inputs, static_cast<double*>(registers_of(tape.registers * sizeof(double))));
}

Tape tape_of(Expression& expression, NodeId node) {
  expression.set_root(node);
  return make_tape(simplify(expression));
}

}  // namespace

Components::Components(const Expression& expression) {
  Expression copy = expression;
  root_ = add(copy, expression.root(), 0);
}

int Components::add(Expression& expression, NodeId id, int depth) {
  const Node node = expression.node(id);
  Part part{node.op};
  const bool inner =
      node.op == Op::min || node.op == Op::max || node.op == Op::negate || node.op == Op::choose;
  if (!inner || depth >= kDeepest || parts_.size() >= kMostParts) {
    part.op = Op::variable;
    part.tape = static_cast<int>(leaves_.size());
    leaves_.push_back(tape_of(expression, id));
  } else if (node.op == Op::choose) {
    part.tape = static_cast<int>(conditions_.size());
    conditions_.push_back(tape_of(expression, node.a));
    part.a = add(expression, node.b, depth + 1);
    part.b = add(expression, node.c, depth + 1);
  } else {
    part.a = add(expression, node.a, depth + 1);
    if (node.op != Op::negate) part.b = add(expression, node.b, depth + 1);
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
      const Tape& condition = conditions_[static_cast<std::size_t>(part.tape)];
      return value(evaluate_at(condition, inputs) != 0 ? part.a : part.b, inputs);
    }
    case Op::min:
    case Op::max: {
      const Value a = value(part.a, inputs), b = value(part.b, inputs);
      const bool second = part.op == Op::min ? b.f < a.f : b.f > a.f;
      return second ? b : a;
    }
    default: return {evaluate_at(leaves_[static_cast<std::size_t>(part.tape)], inputs), part.tape};
  }
}

int Components::at(const Double3& p, double time) const {
  if (count() == 1) return 0;
  const double inputs[4] = {p[0], p[1], p[2], time};
  return value(root_, inputs).leaf;
}

}  // namespace isocast
