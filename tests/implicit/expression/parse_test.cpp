// The grammar, and what it says about text that is no formula.
#include <catch2/catch.hpp>
#include <numbers>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

TEST_CASE("operators bind and group as in mathematics") {
  CHECK(value("1 + 2*3") == 7);
  CHECK(value("(1 + 2)*3") == 9);
  CHECK(value("10 - 4 - 3") == 3);
  CHECK(value("24/4/2") == 3);
  CHECK(value("24/4*2") == 12);
  CHECK(value("2^3^2") == 512);
  CHECK(value("(2^3)^2") == 64);
  CHECK(value("2*3^2") == 18);
  CHECK(value("-x^2", {3}) == -9);
  CHECK(value("(-x)^2", {3}) == 9);
  CHECK(value("-2^2") == -4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("2^-x^2", {2}) == 0.0625);
  CHECK(value("2*-x", {3}) == -6);
  CHECK(value("2--x", {3}) == 5);
  CHECK(value("--x", {3}) == 3);
  CHECK(value("+x - +2", {3}) == 1);
  CHECK(value("-x*y", {2, 5}) == -10);
}

TEST_CASE("numbers, blanks and lines") {
  CHECK(value("1") == 1);
  CHECK(value(".5") == 0.5);
  CHECK(value("5.") == 5);
  CHECK(value("1e-3") == 1e-3);
  CHECK(value("1E+3") == 1e3);
  CHECK(value(" -x\t+\r\n 1 \n", {3}) == -2);
  CHECK(value("2e3 + 2") == 2002);
}

TEST_CASE("variables, constants and parameters") {
  CHECK(value("x + 10*y + 100*z + 1000*w", {1, 2, 3, 4}) == 4321);
  CHECK(value("pi") == std::numbers::pi);
  CHECK(value("e") == std::numbers::e);
  CHECK(value("phi") == std::numbers::phi);
  const auto number = [](std::string_view text) { return decimal_constant(text).value(); };
  CHECK(value("a*x", {2}, {{"a", number("3")}}) == 6);
  CHECK(value("phi", {}, {{"phi", number("0.5")}}) == 0.5);
}

TEST_CASE("a later parameter overrides an earlier one, and keeps its decimals") {
  const auto number = [](std::string_view text) { return decimal_constant(text).value(); };
  const Expression formula = parse_expression("a", {{"a", number("1")}, {"a", number("0.1")}});
  CHECK(formula.constant_at(formula.root()).text == "1e-1");
  CHECK(complaint("x + sin", {{"sin", number("1")}}) ==
        "the parameter 'sin' has the name of a variable or a function, expected a name of its own");
  CHECK(complaint("x", {{"x", number("1")}}) ==
        "the parameter 'x' has the name of a variable or a function, expected a name of its own");
}

TEST_CASE("literals stay exact in the graph, before and after simplification") {
  const Expression formula = simplify(parse_expression("x + 0.1"));
  REQUIRE(formula.constants().size() == 1);
  CHECK(formula.constants()[0].text == "1e-1");
}

TEST_CASE("errors say where, what was found and what was expected") {
  CHECK(complaint("x + )") == "formula:1:5: found ')', expected a number, a name or '('");
  CHECK(complaint("x +") == "formula:1:4: found the end of the formula, expected a number, a name or '('");
  CHECK(complaint("") == "formula:1:1: found the end of the formula, expected a number, a name or '('");
  CHECK(complaint("(x + 1") == "formula:1:7: found the end of the formula, expected an operator or ')'");
  CHECK(complaint("x y") == "formula:1:3: found 'y', expected an operator or the end of the formula");
  CHECK(complaint("2x") == "formula:1:2: found 'x', expected an operator or the end of the formula");
  CHECK(complaint("1.2.3") == "formula:1:4: found '.3', expected an operator or the end of the formula");
  CHECK(complaint("x\n + y\n  * * z") == "formula:3:5: found '*', expected a number, a name or '('");
  CHECK(complaint("sin x") == "formula:1:5: found 'x', expected '(' after the function sin");
  CHECK(complaint("sin()") == "formula:1:5: found ')', expected a number, a name or '('");
  CHECK(complaint("1 + sin(x, y)") == "formula:1:5: found 2 arguments of sin, expected 1");
  CHECK(complaint("min(x)") == "formula:1:1: found 1 argument of min, expected at least 2");
  CHECK(complaint("max(x, y") ==
        "formula:1:9: found the end of the formula, expected an operator, ',' or ')'");
  CHECK(complaint("x, y") == "formula:1:2: found ',', expected an operator or the end of the formula");
  CHECK(complaint("x # y") ==
        "formula:1:3: found the character '#', expected a number, a name, an operator or a parenthesis");
  CHECK(complaint("1 + 1e999") ==
        "formula:1:5: found '1e999', expected a number within the range of double precision");
  CHECK(complaint("1e-999").starts_with("formula:1:1: found '1e-999'"));
}

TEST_CASE("an unknown name comes with the nearest known one") {
  const std::string expected =
      ", expected a variable (x y z w), a parameter, a constant (pi e phi) or a function; the nearest is ";
  CHECK(complaint("1 + sine(x)") == "formula:1:5: found the unknown name 'sine'" + expected + "'sin'");
  CHECK(complaint("Pi*x") == "formula:1:1: found the unknown name 'Pi'" + expected + "'pi'");
  CHECK(complaint("radus - x", {{"radius", exact_constant(1)}}) ==
        "formula:1:1: found the unknown name 'radus'" + expected + "'radius'");
}

TEST_CASE("text in other alphabets is shown, and columns count characters") {
  CHECK(complaint("x − 1") ==
        "formula:1:3: found the character '−', expected a number, a name, an operator or a parenthesis");
  CHECK(complaint("é").starts_with("formula:1:1: found the character 'é'"));
  CHECK(complaint("x\xff").starts_with("formula:1:2: found the byte 0xFF"));
  CHECK(complaint(std::string_view("x\0y", 3)).starts_with("formula:1:2: found the byte 0x00"));
  CHECK(complaint("\xe2\x88").starts_with("formula:1:1: found the byte 0xE2"));
}

TEST_CASE("depth and length are bounded") {
  const auto nested = [](std::size_t n) { return std::string(n, '(') + "x" + std::string(n, ')'); };
  CHECK(complaint(nested(999)).empty());
  CHECK(complaint(nested(1000)) == "formula:1:1001: found 'x', expected at most 1000 nested parts");
  CHECK(complaint(std::string(500000, '(')) ==
        "formula:1:1001: found '(', expected at most 1000 nested parts");
  CHECK(complaint(std::string(10 << 20, '(')) == "formula: found 10485760 bytes, expected at most 1048576");
  CHECK(complaint(std::string(500000, '-') + "x").ends_with("expected at most 1000 nested parts"));

  // powers and calls nest, too
  std::string powers = "x", calls;
  for (int i = 0; i < 5000; ++i) powers += "^x", calls += "sin(";
  CHECK(complaint(powers).ends_with("expected at most 1000 nested parts"));
  CHECK(complaint(calls).ends_with("expected at most 1000 nested parts"));
}

TEST_CASE("a long formula is no deep one") {
  std::string sum = "x", arguments = "min(x";
  for (int i = 0; i < 100000; ++i) sum += "+y", arguments += ",y";
  CHECK(value(sum, {1, 1}) == 100001);
  CHECK(value(arguments + ")", {1, 2}) == 1);
}

TEST_CASE("a long name is cut in the message") {
  CHECK(complaint(std::string(100000, 'a')) ==
        "formula:1:1: found the unknown name '" + std::string(40, 'a') +
            "...', expected a variable (x y z w), a parameter, a constant (pi e phi) or a function");
  CHECK(complaint(std::string(1000, '9')).starts_with("formula:1:1: found '9999"));
}
