// What is rewritten, what is left alone, and the tape that comes of it.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

Tape tape_of(std::string_view text) { return make_tape(simplify(parse_expression(text))); }

// The tape's operations in order, such as "variable square".
std::vector<Op> operations(std::string_view text) {
  std::vector<Op> operations;
  for (const Instruction& instruction : tape_of(text).code) operations.push_back(instruction.op);
  return operations;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("equal parts are computed once") {
  CHECK(tape_of("sin(x*y) + sin(x*y)").code.size() == 5);
  CHECK(tape_of("(x + y)*(y + x)").code.size() == 4);
  CHECK(tape_of("0.5*x + .50*x").code.size() == 4);
  CHECK(operations("x*x") == std::vector{Op::variable, Op::square});
}

TEST_CASE("constants are folded when the result is exact, and only then") {
  const std::vector<Op> one_number = {Op::constant};
  for (const char* text : {"1 + 2", "9/4", "2^10", "2^-1", "sqrt(4)", "abs(-3)", "-3", "min(1, 2, 3)",
                           "0.5*0.25", "floor(2.5)", "(1 + 2)*3", "2 - 2"})
    CHECK(operations(text) == one_number);
  for (const char* text : {"0.1 + 0.2", "1/3", "sqrt(2)", "2*pi", "9/80", "1e300*1e300", "1e-300*1e-300",
                           "exp(0)", "1/0", "0.1*1e1", "1e16 + 1", "0*-1"})
    CHECK(operations(text).size() > 1);
  CHECK(operations("x + abs(-3)") == std::vector{Op::variable, Op::constant, Op::add});
  CHECK(value("9/4") == 2.25);
  CHECK(value("2 - 2") == 0);
}

TEST_CASE("what changes nothing is left out") {
  const std::vector<Op> x = {Op::variable};
  for (const char* text : {"x*1", "1*x", "x/1", "x - 0", "x^1", "--x", "x^(3 - 2)"})
    CHECK(operations(text) == x);
  CHECK(operations("x^2 + 0") == std::vector{Op::variable, Op::square});
  CHECK(operations("x/4") == std::vector{Op::variable, Op::constant, Op::multiply});
  CHECK(operations("x/3") == std::vector{Op::variable, Op::constant, Op::divide});
  CHECK(operations("x + -y") == std::vector{Op::variable, Op::variable, Op::subtract});
  CHECK(operations("x - -y") == std::vector{Op::variable, Op::variable, Op::add});
}

TEST_CASE("conditions are made only once") {
  CHECK(operations("if(not x, y, z)") == operations("if(x, z, y)"));
  CHECK(operations("if(not (x < y), 1, 2)") == operations("if(x >= y, 1, 2)"));
  CHECK(operations("not not (x < y)") == operations("x < y"));
  CHECK(operations("if(1 < 2, x, sqrt(y))") == std::vector{Op::variable});
  CHECK(operations("if(0, x, y)") == std::vector{Op::variable});
  CHECK(operations("x >= y and y >= z").size() == 6);
  CHECK(operations("sign(-3) + step(1, 2)") == std::vector{Op::constant});
  CHECK(operations("if(x, y, y)").size() > 1);
}

TEST_CASE("integer powers become repeated squaring") {
  CHECK(operations("x^2").back() == Op::square);
  CHECK(operations("x^3").back() == Op::power);
  CHECK(operations("x^-3").back() == Op::power);
  CHECK(operations("pow(x, 4)").back() == Op::power);
  CHECK(operations("x^1024").back() == Op::power);
  CHECK(operations("x^1025").back() == Op::pow);
  CHECK(operations("x^0.5").back() == Op::pow);
  CHECK(operations("x^y").back() == Op::pow);
  CHECK(value("x^3", {-2}) == -8);
  CHECK(value("x^-2", {4}) == 0.0625);
  CHECK(value("x^0", {5}) == 1);
  CHECK(value("x^500", {1.01}) == Approx(std::pow(1.01, 500)).epsilon(1e-13));
  CHECK(value("x^1025", {-1}) == -1);
}

TEST_CASE("NaN and the sign of zero survive") {
  for (const char* text : {"x*0", "0*x", "x - x", "x/x", "0/x", "x + 0", "x*0 + y", "sign(x)", "step(0, x)",
                           "x^2 - x^2", "abs(x)"})
    CHECK(std::isnan(value(text, {kNaN, 1})));
  CHECK(std::isnan(value("x/x", {0})));
  CHECK(std::isnan(value("sqrt(x)", {-1})));
  CHECK(same_bits(value("x + 0", {-0.0}), 0.0));
  CHECK(same_bits(value("x - 0", {-0.0}), -0.0));
  CHECK(same_bits(value("x*1", {-0.0}), -0.0));
  CHECK(same_bits(value("0*-1"), -0.0));
  CHECK(same_bits(value("-0"), -0.0));
}

TEST_CASE("simplifying does not change bits, powers apart") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (const char* text :
       {"--x + 0 - (y + 0)*1", "-x + -y - -z*x*x/8", "(2*3 + 1/4)*x/2 + 0*y", "x*y + y*x - (z + -x)/0.5",
        "max(x, y + 0) - min(-x, --z) + (x - 0)/(1 - 3)",
        "if(not (x < y), x*1, -y) + (x <= 0 and not y or z > 1)", "if(x, y, z) - (not not x)*(x != y)"}) {
    const Expression plain = parse_expression(text);
    const Tape before = make_tape(plain), after = make_tape(simplify(plain));
    CHECK(after.code.size() < before.code.size());
    for (int i = 0; i < 1000; ++i) {
      const std::array<double, 4> at = {coordinate(random), i % 7 ? coordinate(random) : -0.0,
                                        coordinate(random), 0};
      REQUIRE(same_bits(run(before, at), run(after, at)));
    }
  }
}

TEST_CASE("few registers are used, and no more than the tape says") {
  CHECK(tape_of("x + y + z + w + x*y + z*w").registers <= 6);
  CHECK(tape_of("x*(x*(x*(x*(x + 1) + 2) + 3) + 4)").registers <= 3);
  CHECK(tape_of("1 + y*(2 + y*(3 + y*(4 + y*(5 + y))))").registers <= 3);

  for (const char* text : {"x", "x^2 + y^2", "min(x, y, z, w) - 1"}) {
    const Tape tape = tape_of(text);
    for (const Instruction& i : tape.code) CHECK(i.out < tape.registers);
    CHECK(tape.result < tape.registers);
  }
}

TEST_CASE("operands that the root does not need are not computed") {
  CHECK(tape_of("2*3*x").code.size() == 3);
  CHECK(tape_of("x").code.size() == 1);
}
