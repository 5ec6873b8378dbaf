// Values of options from text.
#include <isocast/apps/isocast/parse_values.h>

#include <catch2/catch.hpp>

using namespace isocast;

TEST_CASE("numbers and lists of numbers") {
  CHECK(parse_number(" -2.5e1 ", "--a") == -25);
  CHECK(parse_numbers("1, 2,-3", "--a") == std::vector<double>{1, 2, -3});
  CHECK_THROWS_WITH(parse_number("two", "--a"), "--a: found 'two', expected a number");
  CHECK_THROWS_WITH(parse_number("1e999", "--a"), "--a: found '1e999', expected a number");
  CHECK_THROWS_WITH(parse_numbers("1,,2", "--a"), "--a: found '', expected a number");
  CHECK_THROWS_WITH(parse_number("nan", "--a"), "--a: found 'nan', expected a number");
}

TEST_CASE("dimensions") {
  using Dims = std::array<std::int64_t, 3>;
  CHECK(parse_dims("64", "--dims") == Dims{64, 64, 64});
  CHECK(parse_dims("1,2,3", "--dims") == Dims{1, 2, 3});
  for (const char* text : {"", "1,2", "1,2,3,4", "0", "-1", "1.5", "4x4x4", "99999999999999999999", ","})
    CHECK_THROWS_WITH(parse_dims(text, "--dims"), "--dims: found '" + std::string(text) +
                                                      "', expected N or X,Y,Z, whole numbers above 0");
}

TEST_CASE("domains") {
  const Domain cube = parse_domain(" -3,3", "--domain");
  CHECK(cube.lo == std::array<double, 3>{-3, -3, -3});
  CHECK(cube.hi == std::array<double, 3>{3, 3, 3});
  const Domain box = parse_domain("0,1,2,3,4,5", "--domain");
  CHECK(box.lo == std::array<double, 3>{0, 2, 4});
  CHECK(box.hi == std::array<double, 3>{1, 3, 5});
  CHECK_THROWS_WITH(parse_domain("1", "--domain"),
                    "--domain: found '1', expected LO,HI or XLO,XHI,YLO,YHI,ZLO,ZHI");
  CHECK_THROWS_WITH(parse_domain("1,1", "--domain"), "--domain: found '1,1', expected every LO below its HI");
}

TEST_CASE("keys with values") {
  CHECK(parse_key_value("a=b=c", "--set") == std::pair<std::string, std::string>("a", "b=c"));
  for (const char* text : {"", "a", "a=", "=b", "="})
    CHECK_THROWS_WITH(parse_key_value(text, "--set"),
                      "--set: found '" + std::string(text) + "', expected NAME=VALUE");
  const Parameters parameters = parse_parameters({"a=0.1", "b=-2"}, "--param");
  REQUIRE(parameters.size() == 2);
  CHECK(parameters[0].value.text == "1e-1");
  CHECK(parameters[1].value.value == -2);
  CHECK_THROWS_WITH(parse_parameters({"a=x"}, "--param"), "--param: found 'a=x', expected NAME=NUMBER");
}

TEST_CASE("the blank that protects a leading minus sign goes") {
  CHECK(typed_formula(" -x") == "-x");
  CHECK(typed_formula("x - 1") == "x - 1");
  CHECK(typed_formula("  -x") == "  -x");
}
