#include <isocast/implicit/expression/infix.h>

#include <algorithm>
#include <iterator>

namespace isocast {
namespace {

template <Op op> NodeId two(Expression& e, NodeId a, NodeId b) { return e.binary(op, a, b); }

// 1 - a, which is "not" of a truth.
NodeId opposite(Expression& e, NodeId a) { return e.binary(Op::subtract, e.constant(exact_constant(1)), a); }

// 1 for any number but 0.
NodeId truth(Expression& e, NodeId a) { return e.unary(Op::sign, e.unary(Op::abs, a)); }

NodeId at_least(Expression& e, NodeId a, NodeId b) { return e.binary(Op::step, b, a); }
NodeId at_most(Expression& e, NodeId a, NodeId b) { return e.binary(Op::step, a, b); }
NodeId less(Expression& e, NodeId a, NodeId b) { return opposite(e, at_least(e, a, b)); }
NodeId greater(Expression& e, NodeId a, NodeId b) { return opposite(e, at_most(e, a, b)); }
NodeId equal(Expression& e, NodeId a, NodeId b) {
  return e.binary(Op::multiply, at_most(e, a, b), at_least(e, a, b));
}
NodeId different(Expression& e, NodeId a, NodeId b) { return opposite(e, equal(e, a, b)); }

NodeId logical_and(Expression& e, NodeId a, NodeId b) {
  return e.binary(Op::multiply, truth(e, a), truth(e, b));
}
NodeId logical_or(Expression& e, NodeId a, NodeId b) {
  return e.unary(Op::sign, e.binary(Op::add, truth(e, a), truth(e, b)));
}

constexpr Infix kInfix[] = {
    {"or", 0, logical_or},
    {"and", 1, logical_and},
    {"<", kComparisonLevel, less},
    {">", kComparisonLevel, greater},
    {"<=", kComparisonLevel, at_most},
    {">=", kComparisonLevel, at_least},
    {"==", kComparisonLevel, equal},
    {"!=", kComparisonLevel, different},
    {"+", 3, two<Op::add>},
    {"-", 3, two<Op::subtract>},
    {"*", 4, two<Op::multiply>},
    {"/", 4, two<Op::divide>},
};

}  // namespace

const Infix* find_infix(std::string_view symbol) {
  const auto found = std::ranges::find(kInfix, symbol, &Infix::symbol);
  return found == std::end(kInfix) ? nullptr : found;
}

NodeId logical_not(Expression& expression, NodeId a) { return opposite(expression, truth(expression, a)); }

}  // namespace isocast
