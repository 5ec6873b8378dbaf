// Definitions, functions, sums, truth: what they mean, what is refused, and that nothing runs away.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string repeated(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

}  // namespace

TEST_CASE("definitions name numbers and functions") {
  CHECK(value("let r = sqrt(x^2 + y^2); f(a, b) = a*b + 1; f(r, z)", {3, 4, 2}) == 11);
  CHECK(value("r = x + 1; r*r", {2}) == 9);
  CHECK(value("let sq(a) = a*a; sq(sq(x)) + sq(2)", {3}) == 85);
  CHECK(value("f(a) = a + x; g(a) = 10*f(a); g(y)", {1, 2}) == 30);
  CHECK(value("let e = 2; e*x", {3}) == 6);
  CHECK(value("k = 2; f(k) = k + 1; f(x) + k", {5}) == 8);
  CHECK(value("f(a, b) = a - b; f(b, a)", {}, {{"a", exact_constant(1)}, {"b", exact_constant(5)}}) == 4);
  CHECK(value("f(a) = a; g(a) = f(a + 1) + a; g(1)") == 3);
}

TEST_CASE("a call is the same graph as its body written out") {
  const auto size = [](std::string_view text) {
    return make_tape(simplify(parse_expression(text))).code.size();
  };
  CHECK(size("f(a) = sin(a)^2; f(x) + f(x)") == size("sin(x)^2 + sin(x)^2"));
  CHECK(size("unused = sin(y); f(a) = cos(a); x") == 1);
}

TEST_CASE("sums over lists") {
  CHECK(value("sum(a in [1, 2, 3], a*x)", {10}) == 60);
  CHECK(value("sum((a, b, c) in [(0, 0, 1), (1, 0, 2)], (x - a)^2 + (y - b)^2 + (z - c)^2)", {1, 1, 1}) == 4);
  CHECK(value("sum(a in [x, y + 1], sum(b in [a, 2], a*b))", {3, 4}) == 50);
  CHECK(value("2*sum(a in [1], a) + 1") == 3);
  CHECK(value("f(c) = sum(a in [c, 1], a^2); f(3) + f(x)", {2}) == 15);
  CHECK(value("sum(n in [1, 2, 3], chebyshev(n, x))", {0.5}) == 0.5 - 0.5 - 1);

  // a sum goes from left to right, as its text would
  CHECK(value("sum(a in [1, 1e16, -1e16], a)") == value("1 + 1e16 - 1e16"));
}

TEST_CASE("75 blobs are one line") {
  std::string list, written;
  for (int i = 0; i < 75; ++i) {
    const double c = 0.01 * i, d = i % 7;
    list += fmt::format("{}({}, {}, 0.5)", i ? ", " : "", c, d);
    written += fmt::format("{}exp(-((x - {})^2 + (y - {})^2 + (z - 0.5)^2))", i ? " + " : "", c, d);
  }
  const std::string summed = "sum((a, b, c) in [" + list + "], exp(-((x - a)^2 + (y - b)^2 + (z - c)^2)))";
  CHECK(value(summed, {0.3, 1, 0.2}) == value(written, {0.3, 1, 0.2}));
}

TEST_CASE("comparisons are 1 or 0") {
  const struct {
    const char* text;
    double less, equal, greater;
  } cases[] = {{"x < y", 1, 0, 0},  {"x <= y", 1, 1, 0}, {"x > y", 0, 0, 1},
               {"x >= y", 0, 1, 1}, {"x == y", 0, 1, 0}, {"x != y", 1, 0, 1}};
  for (const auto& test : cases) {
    INFO(test.text);
    CHECK(value(test.text, {1, 2}) == test.less);
    CHECK(value(test.text, {2, 2}) == test.equal);
    CHECK(value(test.text, {-0.0, 0.0}) == test.equal);
    CHECK(value(test.text, {3, 2}) == test.greater);
    CHECK(value(test.text, {1e308, std::numeric_limits<double>::infinity()}) == test.less);
    CHECK(std::isnan(value(test.text, {kNaN, 2})));
    CHECK(std::isnan(value(test.text, {2, kNaN})));
  }
}

TEST_CASE("and, or and not take any number but 0 as true") {
  for (const double a : {0.0, 1.0, -3.0, 1e-300})
    for (const double b : {0.0, 1.0, 1e-300}) {
      CHECK(value("x and y", {a, b}) == double(a != 0 && b != 0));
      CHECK(value("x or y", {a, b}) == double(a != 0 || b != 0));
      CHECK(value("not x", {a}) == double(a == 0));
      CHECK(value("not not x", {a}) == double(a != 0));
      CHECK(value("if(not (x or y), 5, 6)", {a, b}) == (a != 0 || b != 0 ? 6 : 5));
    }
  CHECK(std::isnan(value("x and 0", {kNaN})));
  CHECK(std::isnan(value("1 or x", {kNaN})));
}

TEST_CASE("comparisons bind looser than sums, not looser, then and, then or") {
  CHECK(value("1 + 1 < 2*2") == 1);
  CHECK(value("not 1 < 0") == 1);
  CHECK(value("1 or 0 and 0") == 1);
  CHECK(value("not 0 and 0") == 0);
  CHECK(value("0 < 1 and 2 > 1 or 0") == 1);
  CHECK(value("(x > 0)*y", {3, 7}) == 7);
  CHECK(value("-x < 1", {0}) == 1);
}

TEST_CASE("if takes one of two numbers, and only that one has to be defined") {
  CHECK(value("if(x > 0, sqrt(x), -x)", {4}) == 2);
  CHECK(value("if(x > 0, sqrt(x), -x)", {-4}) == 4);
  CHECK(value("if(x, 1, 2)", {0}) == 2);
  CHECK(value("if(x, 1, 2)", {-0.5}) == 1);
  CHECK(value("if(x < -1 or x > 1 and y == 0, 1, 2)", {5, 0}) == 1);
  CHECK(std::isnan(value("if(x < 0, 1, 2)", {kNaN})));
  CHECK(std::isnan(value("if(x, 1, 2)", {kNaN})));
}

TEST_CASE("mistakes in definitions are named") {
  CHECK(complaint("let x = 3; x") == "formula:1:5: found the name 'x', which is taken, expected a new name");
  CHECK(complaint("let sin(a) = 3; 1") ==
        "formula:1:5: found the name 'sin', which is taken, expected a new name");
  CHECK(complaint("a = 1; a = 2; a") ==
        "formula:1:8: found the name 'a', which is taken, expected a new name");
  CHECK(complaint("a = 1; a", {{"a", exact_constant(1)}}) ==
        "formula:1:1: found the name 'a', which is taken, expected a new name");
  CHECK(complaint("f(a, a) = 1; 1") ==
        "formula:1:6: found the name 'a', which is taken, expected a new name");
  CHECK(complaint("let 3 = 4; 1") == "formula:1:5: found '3', expected a new name");
  CHECK(complaint("f() = 4; 1") == "formula:1:3: found ')', expected a new name");
  CHECK(complaint("let f 4") == "formula:1:7: found '4', expected '=' or '('");
  CHECK(complaint("a = 4") == "formula:1:6: found the end of the formula, expected an operator or ';'");
  CHECK(complaint("a = 4;") == "formula:1:7: found the end of the formula, expected a number, a name or '('");
  CHECK(complaint("x + let") == "formula:1:5: found 'let', expected a number, a name or '('");
  CHECK(complaint("f(a) = a; f(1, 2)") == "formula:1:11: found 2 arguments of f, expected 1");
  CHECK(complaint("f(a) = a; f + 1") == "formula:1:13: found '+', expected '(' after the function f");
  CHECK(complaint("f(a) = a + b; 1").starts_with("formula:1:12: found the unknown name 'b'"));
  CHECK(complaint("f(a) = a; a").starts_with("formula:1:11: found the unknown name 'a'"));
  CHECK(complaint(std::string(65, 'a') + " = 1; 1").ends_with("expected a name of at most 64 characters"));
}

TEST_CASE("mistakes in sums, comparisons and degrees are named") {
  CHECK(complaint("sum(a in [], a)") == "formula:1:11: found ']', expected a number, a name or '('");
  CHECK(complaint("sum(a in 3, a)") == "formula:1:10: found '3', expected '['");
  CHECK(complaint("sum(a [3], a)") == "formula:1:7: found '[', expected 'in'");
  CHECK(complaint("sum((a, b) in [(1, 2), (3, 4, 5)], a)") ==
        "formula:1:24: found an element of 3, expected 2 numbers, one for each name");
  CHECK(complaint("sum((a, b) in [1], a)") == "formula:1:16: found '1', expected '(' and 2 numbers");
  CHECK(complaint("sum(a in [1, 2], a) + a").starts_with("formula:1:23: found the unknown name 'a'"));
  CHECK(complaint("sum(x in [1], x)") ==
        "formula:1:5: found the name 'x', which is taken, expected a new name");
  CHECK(complaint("0 < x < 1") == "formula:1:7: found '<', expected 'and' or 'or' after a comparison");
  CHECK(complaint("if(x = 1, 2, 3)") == "formula:1:6: found '=', expected an operator, ',' or ')'");
  CHECK(complaint("if(x, 1)") == "formula:1:1: found 2 arguments of if, expected 3");
  CHECK(complaint("x ! y").starts_with("formula:1:3: found the character '!'"));
  for (const char* text : {"chebyshev(x, x)", "chebyshev(1.5, x)", "chebyshev(1025, x)",
                           "chebyshev(1e300, x)", "chebyshev(-1, x)"})
    CHECK(
        complaint(text) ==
        "formula:1:1: found a degree of chebyshev that is no plain number in range, expected a whole number "
        "from 0 to 1024");
  CHECK(complaint("t(n) = chebyshev(n, x); t(3) + t(0.5)").starts_with("formula:1:8: found a degree"));
}

TEST_CASE("nothing calls itself") {
  const std::string expected = " in its own definition, expected only names that are defined before";
  CHECK(complaint("f(a) = f(a - 1); f(x)") == "formula:1:8: found 'f'" + expected);
  CHECK(complaint("a = a + 1; a") == "formula:1:5: found 'a'" + expected);
  CHECK(complaint("f(a) = g(a); g(a) = f(a); g(x)").starts_with("formula:1:8: found the unknown name 'g'"));
}

TEST_CASE("what is written out is bounded") {
  const std::string words = "found more than 1048576 words with functions and sums written out";
  const auto is_too_long = [&](std::string_view text) {
    return complaint(text).find(words) != std::string::npos;
  };

  // each function calls the one before, twice or once
  std::string doubling = "f0(a) = sin(a);", chain = doubling;
  for (int i = 1; i < 60; ++i) doubling += fmt::format("f{0}(a) = f{1}(a) + f{1}(a + 1);", i, i - 1);
  for (int i = 1; i < 1200; ++i) chain += fmt::format("f{}(a) = f{}(a);", i, i - 1);
  CHECK(is_too_long(doubling + "f59(x)"));
  CHECK(is_too_long(chain + "f1199(x)"));

  // sums in sums, and long lists
  std::string nested;
  for (int i = 0; i < 20; ++i) nested += fmt::format("sum(a{} in [{}1], ", i, repeated(99, "1,"));
  CHECK(is_too_long(nested + "x" + repeated(20, ")")));
  CHECK(is_too_long("sum(a in [" + repeated(400000, "1,") + "1], a*x + 1)"));
  CHECK(value("sum(a in [" + repeated(99999, "1,") + "1], a*x)", {1}) == 100000);
}

TEST_CASE("names at once are bounded") {
  std::string parameters = "a0", sums;
  for (int i = 1; i < 65; ++i) parameters += fmt::format(", a{}", i);
  for (int i = 0; i < 65; ++i) sums += fmt::format("sum(b{} in [1], ", i);
  CHECK(complaint(std::string("f(") + parameters + ") = 1; 1")
            .ends_with("expected at most 64 names in one place"));
  CHECK(complaint(sums + "x" + repeated(65, ")")).ends_with("expected at most 64 names in one place"));
}

TEST_CASE("many definitions and operators are no deep formula") {
  std::string definitions;
  for (int i = 0; i < 40000; ++i) definitions += fmt::format("v{0} = {0};", i);
  CHECK(value(definitions + "v39999 - v1") == 39998);
  CHECK(value(repeated(200000, "not ") + "x", {3}) == 1);
  CHECK(value(std::string("x") + repeated(100000, " and x"), {3}) == 1);
  CHECK(complaint(repeated(300000, "if(")).ends_with("expected at most 1000 nested parts"));
  CHECK(complaint(repeated(100000, "f(") + "=").starts_with("formula:1:1: found the unknown name 'f'"));
}
