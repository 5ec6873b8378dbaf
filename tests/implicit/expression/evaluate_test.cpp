// Every operation against the standard library, one at a time and in blocks.
#include <test_size.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// A formula of x and y, what it should be, and where x is defined.
struct Case {
  const char* text;
  double (*expected)(double x, double y);
  double lo, hi;
};

double fraction(double lo, double hi, double x) { return std::clamp((x - lo) / (hi - lo), 0.0, 1.0); }

const Case kCases[] = {
    {"-x", [](double x, double) { return -x; }, -9, 9},
    {"x + y", [](double x, double y) { return x + y; }, -9, 9},
    {"x - y", [](double x, double y) { return x - y; }, -9, 9},
    {"x*y", [](double x, double y) { return x * y; }, -9, 9},
    {"x/y", [](double x, double y) { return x / y; }, -9, 9},
    {"x^y", [](double x, double y) { return std::pow(x, y); }, 0, 9},
    {"x^2", [](double x, double) { return x * x; }, -9, 9},
    {"x^7", [](double x, double) { return std::pow(x, 7); }, -3, 3},
    {"x^-3", [](double x, double) { return std::pow(x, -3); }, 0.5, 3},
    {"sqrt(x)", [](double x, double) { return std::sqrt(x); }, 0, 9},
    {"cbrt(x)", [](double x, double) { return std::cbrt(x); }, -9, 9},
    {"abs(x)", [](double x, double) { return std::abs(x); }, -9, 9},
    {"sign(x)", [](double x, double) { return double((x > 0) - (x < 0)); }, -9, 9},
    {"min(x, y)", [](double x, double y) { return std::min(x, y); }, -9, 9},
    {"max(x, y)", [](double x, double y) { return std::max(x, y); }, -9, 9},
    {"min(x, y, 1, 0.5)",
     [](double x, double y) {
       return std::min({x, y, 0.5});
     },
     -2, 2},
    {"max(x, y, -1, 0.5)",
     [](double x, double y) {
       return std::max({x, y, 0.5});
     },
     -2, 2},
    {"sin(x)", [](double x, double) { return std::sin(x); }, -20, 20},
    {"cos(x)", [](double x, double) { return std::cos(x); }, -20, 20},
    {"tan(x)", [](double x, double) { return std::tan(x); }, -1.5, 1.5},
    {"asin(x)", [](double x, double) { return std::asin(x); }, -1, 1},
    {"acos(x)", [](double x, double) { return std::acos(x); }, -1, 1},
    {"atan(x)", [](double x, double) { return std::atan(x); }, -9, 9},
    {"atan2(x, y)", [](double x, double y) { return std::atan2(x, y); }, -9, 9},
    {"sinh(x)", [](double x, double) { return std::sinh(x); }, -9, 9},
    {"cosh(x)", [](double x, double) { return std::cosh(x); }, -9, 9},
    {"tanh(x)", [](double x, double) { return std::tanh(x); }, -9, 9},
    {"exp(x)", [](double x, double) { return std::exp(x); }, -9, 9},
    {"log(x)", [](double x, double) { return std::log(x); }, 1.5, 9},
    {"log10(x)", [](double x, double) { return std::log10(x); }, 1.5, 9},
    {"pow(x, y)", [](double x, double y) { return std::pow(x, y); }, 0, 9},
    {"floor(x)", [](double x, double) { return std::floor(x); }, -9, 9},
    {"ceil(x)", [](double x, double) { return std::ceil(x); }, -9, 9},
    {"round(x)", [](double x, double) { return std::round(x); }, -9, 9},
    {"mod(x, 2.5)", [](double x, double) { return x - 2.5 * std::floor(x / 2.5); }, -9, 9},
    {"hypot(x, y)", [](double x, double y) { return std::hypot(x, y); }, -9, 9},
    {"clamp(x, -1, 2)", [](double x, double) { return std::clamp(x, -1.0, 2.0); }, -9, 9},
    {"mix(x, y, 0.25)", [](double x, double y) { return 0.75 * x + 0.25 * y; }, 0, 9},
    {"step(y, x)", [](double x, double y) { return x < y ? 0.0 : 1.0; }, -2, 2},
    {"smoothstep(-1, 2, x)",
     [](double x, double) { return std::pow(fraction(-1, 2, x), 2) * (3 - 2 * fraction(-1, 2, x)); }, -3, 4},
    {"3 + chebyshev(2, x)", [](double x, double) { return 2 * x * x + 2; }, -2, 2},
    {"9 + chebyshev(3, x)", [](double x, double) { return 9 + (4 * x * x - 3) * x; }, -1, 2},
    {"if(x < y, x, 2*y)", [](double x, double y) { return x < y ? x : 2 * y; }, -3, 3},
    {"x < y", [](double x, double y) { return double(x < y); }, -3, 3},
    {"x >= y or not x <= 1", [](double x, double y) { return double(x >= y || x > 1); }, -3, 3},
    {"x != y and x > 0", [](double x, double y) { return double(x != y && x > 0); }, -3, 3},
};

template <class T> bool same_bits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (std::isnan(a) && std::isnan(b));
}

}  // namespace

TEMPLATE_TEST_CASE("operations agree with the standard library", "", float, double) {
  using T = TestType;
  const double ulp = sizeof(T) == 4 ? 0x1p-23 : 0x1p-52;
  std::mt19937_64 random(11);
  for (const Case& test : kCases) {
    INFO(test.text);
    const Tape tape = make_tape(simplify(parse_expression(test.text)));
    std::uniform_real_distribution<T> first(T(test.lo), T(test.hi)), second(T(-3), T(3));
    for (std::int64_t i = 0, n = cases(2000, 1000000); i < n; ++i) {
      const T x = std::clamp(first(random), T(test.lo), T(test.hi)), y = second(random);
      const double expected = test.expected(double(x), double(y)), found = double(run<T>(tape, {x, y, 0, 0}));
      INFO(x << " " << y << " " << found << " " << expected);
      REQUIRE(std::abs(found - expected) <=
              4 * ulp * std::max(std::abs(expected), std::abs(double(x)) * 0.5 + 0.01));
    }
  }
}

TEMPLATE_TEST_CASE("a block has the bits of its points", "", float, double) {
  using T = TestType;
  std::mt19937_64 random(12);
  std::uniform_real_distribution<T> coordinate(T(-3), T(3));
  T x[kBlockPoints], y[kBlockPoints], z[kBlockPoints], w[kBlockPoints];
  const T* const inputs[] = {x, y, z, w};
  for (T* const axis : {x, y, z, w}) std::generate_n(axis, kBlockPoints, [&] { return coordinate(random); });
  std::vector<std::string> texts = {"x", "3", "x^13 + (y*z - w)^-5", "(x + y)^2*(x - y)^3/(z^4 + w^500)"};
  for (const Case& test : kCases) texts.push_back(std::string(test.text) + " + 0.1*z*w");
  for (const std::string& text : texts) {
    INFO(text);
    const Tape tape = make_tape(simplify(parse_expression(text)));
    for (const int count : {1, 3, 64, kBlockPoints - 1, kBlockPoints}) {
      std::vector<T> registers(std::size_t{tape.registers} * kBlockPoints);
      const T* const values = evaluate_block(tape.view(), inputs, count, registers.data());
      for (int i = 0; i < count; ++i) REQUIRE(same_bits(values[i], run<T>(tape, {x[i], y[i], z[i], w[i]})));
    }
  }
}

TEST_CASE("operations at their edges") {
  CHECK(value("round(x)", {2.5}) == 3);
  CHECK(value("round(x)", {-2.5}) == -3);
  CHECK(value("sign(x)", {0}) == 0);
  CHECK(value("step(x, y)", {1, 1}) == 1);
  CHECK(value("mod(x, 3)", {-1}) == 2);
  CHECK(value("atan2(x, y)", {0, -1}) == Approx(3.14159265358979));
  CHECK(value("smoothstep(0, 1, x)", {5}) == 1);
  CHECK(value("clamp(x, 0, 1)", {-5}) == 0);
  CHECK(std::isinf(value("1/x", {0})));
  CHECK(std::isinf(value("log(x)", {0})));
  CHECK(std::isnan(value("log(x)", {-1})));
  CHECK(std::isnan(value("acos(x)", {2})));
  CHECK(std::isnan(value("x^0.5", {-1})));
}
