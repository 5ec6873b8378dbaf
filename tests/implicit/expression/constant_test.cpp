// Numbers are kept exactly.
#include <isocast/implicit/expression/constant.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;

TEST_CASE("a literal is kept as digits and an exponent") {
  const auto text = [](std::string_view literal) { return decimal_constant(literal).value().text; };
  CHECK(text("0.1") == "1e-1");
  CHECK(text(".1") == "1e-1");
  CHECK(text("1e-1") == "1e-1");
  CHECK(text("0.10") == "1e-1");
  CHECK(text("1000") == "1e3");
  CHECK(text("-2.50") == "-25e-1");
  CHECK(text("+7") == "7e0");
  CHECK(text("1.5e+3") == "15e2");
  CHECK(text("2.") == "2e0");
  CHECK(text("0.000") == "0e0");
  CHECK(text("-0") == "0e0");
  CHECK(text("0e999999999999999999999") == "0e0");
  CHECK(text("3.14159265358979323846264338327950288") == "314159265358979323846264338327950288e-35");
}

TEST_CASE("a literal knows its nearest double and whether it is that") {
  CHECK(decimal_constant("0.1")->value == 0.1);
  CHECK_FALSE(decimal_constant("0.1")->exact);
  CHECK(decimal_constant("0.25")->exact);
  CHECK(decimal_constant("9007199254740992")->exact);
  CHECK_FALSE(decimal_constant("9007199254740993")->exact);
  CHECK(decimal_constant("0.1000000000000000055511151231257827021181583404541015625")->exact);
  CHECK(decimal_constant("1e22")->exact);
  CHECK_FALSE(decimal_constant("1e23")->exact);
  CHECK(decimal_constant("5e-1")->exact);
  CHECK(decimal_constant("0")->exact);
  CHECK_FALSE(decimal_constant("5e-324")->exact);
  CHECK(decimal_constant("6103515625e-14")->value == 0x1p-14);
  CHECK(decimal_constant("6103515625e-14")->exact);
  CHECK_FALSE(decimal_constant("61035156250000001e-21")->exact);
  CHECK(decimal_constant("1.7976931348623157e308")->value == std::numeric_limits<double>::max());
}

TEST_CASE("what is no number in the range of double is refused") {
  for (const std::string_view text :
       {"",    "-",    ".",    "e5",  "1e",  "1e+",   "1x",     "1..2",   "1.2.3",
        "--1", "1e5.", "0x10", "inf", "nan", "1e999", "-1e999", "1e-999", "1e99999999999999999999999",
        " 1",  "1 "})
    CHECK_FALSE(decimal_constant(text).has_value());
}

TEST_CASE("a double becomes a constant in two ways") {
  CHECK(shortest_constant(0.1).text == "1e-1");
  CHECK(shortest_constant(-1.6625077511098136).text == "-16625077511098136e-16");
  CHECK(exact_constant(0.1).text == "1000000000000000055511151231257827021181583404541015625e-55");
  for (const double value : {0.0, 1.0, -0.375, 1e300, 5e-324, std::numeric_limits<double>::max(), 0.1}) {
    CHECK(exact_constant(value).value == value);
    CHECK(decimal_constant(exact_constant(value).text)->value == value);
    CHECK(decimal_constant(exact_constant(value).text)->exact);
    CHECK(shortest_constant(value).value == value);
  }
}

TEST_CASE("constants have names") {
  CHECK(named_constant("pi")->value == std::acos(-1.0));
  CHECK(named_constant("e")->value == std::exp(1.0));
  CHECK(named_constant("phi")->value == (1 + std::sqrt(5.0)) / 2);
  CHECK_FALSE(named_constant("pi")->exact);
  CHECK(named_constant("pi")->text == "pi");
  CHECK_FALSE(named_constant("tau").has_value());
}
