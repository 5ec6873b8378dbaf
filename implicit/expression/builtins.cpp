#include <isocast/implicit/expression/builtins.h>

#include <algorithm>
#include <limits>

namespace isocast {
namespace {

using Arguments = std::span<const NodeId>;

template <Op op> NodeId one(Expression& e, Arguments a) { return e.unary(op, a[0]); }
template <Op op> NodeId two(Expression& e, Arguments a) { return e.binary(op, a[0], a[1]); }

// op(op(a, b), c) ...
template <Op op> NodeId fold(Expression& e, Arguments a) {
  NodeId all = a[0];
  for (const NodeId next : a.subspan(1)) all = e.binary(op, all, next);
  return all;
}

NodeId chebyshev(Expression& e, Arguments a) {
  return e.chebyshev(a[1], static_cast<std::int32_t>(e.constant_at(a[0]).value));
}

NodeId choose(Expression& e, Arguments a) { return e.choose(a[0], a[1], a[2]); }

NodeId clamp(Expression& e, Arguments a) { return e.binary(Op::min, e.binary(Op::max, a[0], a[1]), a[2]); }

NodeId hypot(Expression& e, Arguments a) {
  return e.unary(Op::sqrt, e.binary(Op::add, e.unary(Op::square, a[0]), e.unary(Op::square, a[1])));
}

// (1 - t) a + t b
NodeId mix(Expression& e, Arguments a) {
  const NodeId rest = e.binary(Op::subtract, e.constant(exact_constant(1)), a[2]);
  return e.binary(Op::add, e.binary(Op::multiply, rest, a[0]), e.binary(Op::multiply, a[2], a[1]));
}

NodeId mod(Expression& e, Arguments a) {
  const NodeId whole = e.unary(Op::floor, e.binary(Op::divide, a[0], a[1]));
  return e.binary(Op::subtract, a[0], e.binary(Op::multiply, a[1], whole));
}

// t^2 (3 - 2 t) with t = (x - lo) / (hi - lo) inside [0, 1]; the arguments are lo, hi, x
NodeId smoothstep(Expression& e, Arguments a) {
  const auto number = [&](double value) { return e.constant(exact_constant(value)); };
  const NodeId part =
      e.binary(Op::divide, e.binary(Op::subtract, a[2], a[0]), e.binary(Op::subtract, a[1], a[0]));
  const NodeId bounds[] = {part, number(0), number(1)};
  const NodeId t = clamp(e, bounds);
  const NodeId line = e.binary(Op::subtract, number(3), e.binary(Op::multiply, number(2), t));
  return e.binary(Op::multiply, e.unary(Op::square, t), line);
}

constexpr std::size_t kMany = std::numeric_limits<std::size_t>::max();

constexpr Builtin kBuiltins[] = {
    {"abs", 1, 1, one<Op::abs>},
    {"acos", 1, 1, one<Op::acos>},
    {"asin", 1, 1, one<Op::asin>},
    {"atan", 1, 1, one<Op::atan>},
    {"atan2", 2, 2, two<Op::atan2>},
    {"cbrt", 1, 1, one<Op::cbrt>},
    {"ceil", 1, 1, one<Op::ceil>},
    {"chebyshev", 2, 2, chebyshev, true},
    {"clamp", 3, 3, clamp},
    {"cos", 1, 1, one<Op::cos>},
    {"cosh", 1, 1, one<Op::cosh>},
    {"exp", 1, 1, one<Op::exp>},
    {"floor", 1, 1, one<Op::floor>},
    {"hypot", 2, 2, hypot},
    {"if", 3, 3, choose},
    {"log", 1, 1, one<Op::log>},
    {"log10", 1, 1, one<Op::log10>},
    {"max", 2, kMany, fold<Op::max>},
    {"min", 2, kMany, fold<Op::min>},
    {"mix", 3, 3, mix},
    {"mod", 2, 2, mod},
    {"pow", 2, 2, two<Op::pow>},
    {"round", 1, 1, one<Op::round>},
    {"sign", 1, 1, one<Op::sign>},
    {"sin", 1, 1, one<Op::sin>},
    {"sinh", 1, 1, one<Op::sinh>},
    {"smoothstep", 3, 3, smoothstep},
    {"sqrt", 1, 1, one<Op::sqrt>},
    {"step", 2, 2, two<Op::step>},
    {"tan", 1, 1, one<Op::tan>},
    {"tanh", 1, 1, one<Op::tanh>},
};

}  // namespace

std::span<const Builtin> builtins() { return kBuiltins; }

const Builtin* find_builtin(std::string_view name) {
  const auto found = std::ranges::find(kBuiltins, name, &Builtin::name);
  return found == std::end(kBuiltins) ? nullptr : found;
}

}  // namespace isocast
