// Pruned tapes: the same bits inside the box, true inclusions, the same sides of levels, and shorter.
#include <fmt/format.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/prune.h>
#include <isocast/implicit/solve/inclusion.h>
#include <test_size.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

using Box3 = Interval<double>[3];

// The coordinates of a box and of points in it are floats: so they are the same in both precisions.
struct FloatBox {
  float lo[3], hi[3];

  FloatBox(std::mt19937_64& random, const Domain& domain, double size) {
    std::uniform_real_distribution<double> unit(0, 1);
    for (std::size_t a = 0; a < 3; ++a) {
      const double width = size * unit(random) * (domain.hi[a] - domain.lo[a]);
      lo[a] = static_cast<float>(domain.lo[a] + unit(random) * (domain.hi[a] - domain.lo[a] - width));
      hi[a] = static_cast<float>(lo[a] + width);
    }
  }
  std::array<float, 4> point(std::mt19937_64& random, float time) const {
    std::uniform_real_distribution<float> unit(0, 1);
    std::array<float, 4> p = {0, 0, 0, time};
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = random() % 8 ? std::clamp(lo[a] + unit(random) * (hi[a] - lo[a]), lo[a], hi[a])
                          : (random() % 2 ? lo[a] : hi[a]);
    return p;
  }
};

template <class T> bool same_bits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (std::isnan(a) && std::isnan(b));
}
template <class T> int side(T value, T level) { return value < level ? -1 : value > level ? 1 : 0; }

template <class T> Interval<T> range(const Tape& tape, const std::array<Interval<T>, 4>& at) {
  std::vector<Interval<T>> registers(tape.registers);
  return evaluate(tape.view(), at.data(), registers.data());
}
template <class T> std::array<Interval<T>, 4> between(const std::array<T, 4>& a, const std::array<T, 4>& b) {
  std::array<Interval<T>, 4> box;
  for (std::size_t i = 0; i < 4; ++i) box[i] = Interval<T>(std::min(a[i], b[i]), std::max(a[i], b[i]));
  return box;
}

// Two points of the box, and what lies between them.
template <class T>
void check_points(const Tape& whole, const Tape& pruned, const std::array<T, 4>& a,
                  const std::array<T, 4>& b) {
  REQUIRE(same_bits(run<T>(whole, a), run<T>(pruned, a)));
  const Interval<T> truth = range(whole, between(a, a)), found = range(pruned, between(a, b));
  if (truth.empty) REQUIRE_FALSE(found.defined);
  if (!truth.defined) return;  // where f may have no value at all, found may know it
  REQUIRE_FALSE(found.empty);
  REQUIRE(found.lo <= truth.hi);
  REQUIRE(found.hi >= truth.lo);
}

// How many instructions are left, of how many; every property is required.
struct Length {
  std::size_t pruned = 0, whole = 0;
};
void check(const Tape& whole, const FloatBox& box, float time, std::mt19937_64& random, Length& length) {
  static Pruner<float> pruner;
  static Pruner<double> pruner_double;
  const Box3 ranges = {{box.lo[0], box.hi[0]}, {box.lo[1], box.hi[1]}, {box.lo[2], box.hi[2]}};
  const Tape& pruned = pruner.prune(whole, ranges, time);
  const Tape& for_double = pruner_double.prune(whole, ranges, time);
  for (const Tape* tape : {&pruned, &for_double}) {
    REQUIRE(tape->code.size() <= whole.code.size());
    REQUIRE(tape->registers <= whole.registers);
  }
  length.pruned += pruned.code.size(), length.whole += whole.code.size();
  for (int n = 0; n < 8; ++n) {
    const std::array<float, 4> a = box.point(random, time), b = box.point(random, time);
    const std::array<double, 4> at = {a[0], a[1], a[2], a[3]}, to = {b[0], b[1], b[2], b[3]};
    check_points(whole, pruned, a, b);
    check_points(whole, pruned, at, to);
    check_points(whole, for_double, at, to);
  }
}
void check_levels(const Tape& whole, const FloatBox& box, const std::vector<double>& levels,
                  std::mt19937_64& random, Length& length) {
  static Pruner<float> pruner;
  const Box3 ranges = {{box.lo[0], box.hi[0]}, {box.lo[1], box.hi[1]}, {box.lo[2], box.hi[2]}};
  const Tape& pruned = pruner.prune(whole, ranges, 0, levels);
  length.pruned += pruned.code.size(), length.whole += whole.code.size();
  REQUIRE(pruned.registers <= whole.registers);
  for (int n = 0; n < 8; ++n) {
    const std::array<float, 4> a = box.point(random, 0);
    const std::array<double, 4> at = {a[0], a[1], a[2], a[3]};
    const double expected = run(whole, at), found = run(pruned, at);
    const float expected_float = run<float>(whole, a), found_float = run<float>(pruned, a);
    for (const double level : levels) {
      const auto rounded = static_cast<float>(level);
      REQUIRE(side(expected, level) == side(found, level));
      REQUIRE(side(expected_float, rounded) == side(found_float, rounded));
    }
    REQUIRE(std::isnan(expected) == std::isnan(found));
  }
}

// A formula full of choices; some of its parts are undefined, overflow, or are NaN by inf - inf.
Expression random_choices(std::mt19937_64& random) {
  const Op unary[] = {Op::negate, Op::abs, Op::sign, Op::square, Op::sqrt,   Op::exp,  Op::log,   Op::sin,
                      Op::floor,  Op::tan, Op::tanh, Op::abs,    Op::negate, Op::cbrt, Op::round, Op::acos};
  const Op binary[] = {Op::add, Op::subtract, Op::multiply, Op::divide, Op::min, Op::max,   Op::step,
                       Op::min, Op::max,      Op::add,      Op::min,    Op::max, Op::atan2, Op::pow};
  Expression e;
  std::vector<NodeId> nodes = {e.variable(0), e.variable(1), e.variable(2)};
  for (const char* number : {"0", "1", "0.3", "-2", "1e30"})
    nodes.push_back(e.constant(decimal_constant(number).value()));
  const auto any = [&] { return nodes[random() % nodes.size()]; };
  for (std::size_t n = 4 + random() % 24; n > 0; --n) {
    const NodeId newest = random() % 3 ? nodes.back() : any();
    switch (random() % 8) {
      case 0: nodes.push_back(e.choose(newest, any(), any())); break;
      case 1: nodes.push_back(e.choose(e.binary(Op::step, any(), any()), newest, any())); break;
      case 2: nodes.push_back(e.power(newest, static_cast<int>(random() % 12) - 3)); break;
      case 3: nodes.push_back(e.chebyshev(newest, static_cast<int>(random() % 12))); break;
      case 4: nodes.push_back(e.unary(unary[random() % std::size(unary)], newest)); break;
      default: nodes.push_back(e.binary(binary[random() % std::size(binary)], newest, any())); break;
    }
  }
  e.set_root(nodes.back());
  return e;
}

// A union of balls, all of it in one min().
std::string balls(int count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-2, 2);
  std::string text = "min(";
  for (int n = 0; n < count; ++n)
    text += fmt::format("{}sqrt((x - {:.3f})^2 + (y - {:.3f})^2 + (z - {:.3f})^2) - 0.2", n ? ", " : "",
                        place(random), place(random), place(random));
  return text + ")";
}
constexpr Domain kDomain = {{-2, -2, -2}, {2, 2, 2}};

Length check_text(const std::string& text, double size, std::mt19937_64& random) {
  const Tape whole = make_tape(simplify(parse_expression(text)));
  Length length;
  for (int n = 0; n < 200; ++n) check(whole, FloatBox(random, kDomain, size), 0, random, length);
  return length;
}
std::size_t length_over(const char* text, const Interval<double>& x, std::vector<double> levels = {}) {
  Pruner<float> pruner;
  const Box3 box = {x, {-1, 1}, {-1, 1}};
  return pruner.prune(make_tape(simplify(parse_expression(text))), box, 0, levels).code.size();
}

}  // namespace

TEST_CASE("pruned tapes of random formulas have the bits of the whole ones", "[property]") {
  std::mt19937_64 random(1);
  Length length;
  for (std::int64_t n = 0, count = cases(4000, 400'000); n < count; ++n) {
    INFO("formula " << n);
    const Expression expression = random_choices(random);
    const Tape whole = make_tape(n % 2 ? expression : simplify(expression));
    for (const double size : {1.0, 0.1, 0.001})
      check(whole, FloatBox(random, kDomain, size), 0, random, length);
  }
  CHECK(length.pruned < 0.9 * double(length.whole));
}

TEST_CASE("levels keep the sides of random formulas", "[property]") {
  std::mt19937_64 random(2);
  Length length, values;
  for (std::int64_t n = 0, count = cases(4000, 400'000); n < count; ++n) {
    INFO("formula " << n);
    const Tape whole = make_tape(random_choices(random));
    std::vector<double> levels(1 + random() % 3);
    for (double& level : levels) level = std::uniform_real_distribution<double>(-1, 1)(random);
    for (const double size : {0.5, 0.05}) {
      const FloatBox box(random, kDomain, size);
      check_levels(whole, box, levels, random, length);
      check(whole, box, 0, random, values);
    }
  }
  CHECK(length.pruned < values.pruned);
}

TEST_CASE("the catalogue's surfaces, pruned") {
  std::mt19937_64 random(3);
  for (const CatalogueSurface& surface : catalogue()) {
    INFO(surface.id);
    const Tape whole = make_tape(simplify(surface_expression(surface)));
    Length length;
    for (const double size : {0.5, 0.05})
      for (int n = 0; n < 20; ++n)
        check(whole, FloatBox(random, surface.domain, size), 0.25f, random, length);
    if (surface.id == "icos_csg" || surface.id == "sesc_csg") CHECK(length.pruned < length.whole);
    if (surface.id == "decocube") CHECK(length.pruned == length.whole);
  }
}

TEST_CASE("a union of 200 balls is a handful of them in a small box") {
  std::mt19937_64 random(4);
  const std::string text = balls(200, random);
  const Length values = check_text(text, 0.1, random);
  CHECK(double(values.pruned) < 0.2 * double(values.whole));

  const Tape whole = make_tape(simplify(parse_expression(text)));
  Length sides;
  for (int n = 0; n < 200; ++n) check_levels(whole, FloatBox(random, kDomain, 0.1), {0}, random, sides);
  CHECK(double(sides.pruned) < 0.1 * double(sides.whole));
}

TEST_CASE("each choice goes where it is decided and stays where it is not") {
  const std::size_t kVariable = 1, kNumber = 1;
  CHECK(length_over("abs(x)", {0.5, 1}) == kVariable);
  CHECK(length_over("abs(x)", {-1, -0.5}) == 2);
  CHECK(length_over("abs(x)", {0, 1}) == 2);
  CHECK(length_over("sign(x)", {0.5, 1}) == kNumber);
  CHECK(length_over("sign(x)", {0, 1}) == 2);
  CHECK(length_over("min(x, y)", {-3, -2}) == kVariable);
  CHECK(length_over("max(x, y)", {-3, -2}) == kVariable);
  CHECK(length_over("min(x, y)", {-3, -1}) == 3);
  CHECK(length_over("clamp(x, 0, 1)", {2, 3}) == kNumber);
  CHECK(length_over("clamp(x, 0, 1)", {0.25, 0.5}) == kVariable);
  CHECK(length_over("if(x < y, sqrt(z - 5), z)", {2, 3}) == kVariable);
  CHECK(length_over("if(x < y and z < 2 or x < 0, y*z, sin(z))", {-3, -2}) == 3);
  CHECK(length_over("if(x < y and z < 2, y*z, z)", {2, 3}) == kVariable);
  CHECK(length_over("max(sqrt(exp(9*x)), -1)", {-3, 1}) == 5);
  // max(0, y) is -0 at -0, which lies on the other side of the angle's cut; T_50 is computed a little above 1
  CHECK(length_over("min(atan2(max(0, y), x), z)", {-3, -2}) == 7);
  CHECK(length_over("min(chebyshev(50, x), 1.000001)", {0.9, 1}) == 4);
  CHECK(length_over("min(chebyshev(50, x), 1.001)", {0.9, 1}) == 2);
  // not defined, perhaps NaN, infinite
  CHECK(length_over("min(x, 9 + sqrt(y))", {0, 1}) > kVariable);
  CHECK(length_over("max(x, 1/y)", {-1e9, -1e8}) > kVariable);
  CHECK(length_over("max(x, 0*(y^900*10^30^2))", {1, 2}) > kVariable);
  CHECK(length_over("min(x, 9)", {std::numeric_limits<double>::quiet_NaN(), 1}) == 3);
  CHECK(length_over("min(x, 9)", {-std::numeric_limits<double>::infinity(), 1}) == 3);
}

TEST_CASE("levels: parts of a union that no level meets are left out, however nested") {
  const char* const either = "min(x, y + 1)";  // x in 2..3 lies above, y + 1 in 0..2
  CHECK(length_over(either, {1, 3}) == 5);
  CHECK(length_over(either, {1, 3}, {0.5}) == 3);
  CHECK(length_over(either, {1, 3}, {0.5, 1.5}) == 5);
  CHECK(length_over("max(-x, -(y + 1))", {1, 3}, {-0.5}) == 4);
  CHECK(length_over("min(x, max(y, z - 3))", {1.5, 3}, {0}) == 1);
  CHECK(length_over("-min(x, max(y, z - 3))", {1.5, 3}, {-1.25, 1.25}) == 2);
  CHECK(length_over("-min(x, y + 1)", {0.2, 3}, {0.5}) == 2);
  CHECK(length_over("-min(x, y + 1)", {0.2, 3}, {-0.5}) == 6);
  CHECK(length_over("if(z < y, min(x, y), x)", {0.5, 3}) == 6);
  CHECK(length_over("if(z < y, min(x, y), x)", {0.5, 3}, {0}) == 5);
  // below all levels it stands alone
  CHECK(length_over("min(x, x*y*z)", {-2.5, -2}, {1e4}) == 1);
  // what is read for its value as well keeps it
  CHECK(length_over("max(min(x, y), sin(min(x, y)) - 3)", {0.5, 3}, {0}) == 1);
  CHECK(length_over("max(min(x, y), sin(min(x, y)))", {0.5, 3}, {0}) == 5);
  // undefined somewhere: the union is too
  CHECK(length_over("min(5 + sqrt(x), y)", {-1, 3}, {0}) > 1);
  CHECK(length_over("min(x, y)", {1.5, 3}, {std::numeric_limits<double>::quiet_NaN()}) == 1);
  CHECK(length_over("min(x, y)", {0.5, 3}, {std::numeric_limits<double>::quiet_NaN()}) == 3);
}

TEST_CASE("a pruner keeps its memory") {
  std::mt19937_64 random(5);
  const Tape whole = make_tape(simplify(parse_expression(balls(50, random))));
  Pruner<float> pruner;
  const Box3 all = {{-2, 2}, {-2, 2}, {-2, 2}}, small = {{-0.1, 0.1}, {-0.1, 0.1}, {-0.1, 0.1}};
  const Tape& pruned = pruner.prune(whole, all, 0);
  const Instruction* const memory = pruned.code.data();
  const std::size_t length = pruned.code.size();
  CHECK(pruner.prune(whole, small, 0).code.size() < length);
  CHECK(pruner.prune(whole, all, 0).code.size() == length);
  CHECK(pruned.code.data() == memory);
}
