// Scalar spelling of the vocabulary.
#include <isocast/apps/bench/random.h>
#include <isocast/math/real.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;

TEMPLATE_TEST_CASE("inverse_power_of_two brings numbers to [1, 2)", "", float, double) {
  using Limits = std::numeric_limits<TestType>;
  bench::Random random(2, 0);
  for (int n = 0; n < 10'000; ++n) {
    const TestType a = static_cast<TestType>(
        random.sign() * std::exp2(random.uniform(Limits::min_exponent, Limits::max_exponent - 2)));
    const TestType p = inverse_power_of_two(a);
    int exponent;
    REQUIRE(std::frexp(p, &exponent) == TestType(0.5));
    REQUIRE(p * std::abs(a) >= 1);
    REQUIRE(p * std::abs(a) < 2);
  }
  // finite and not zero for everything
  for (const TestType a :
       {TestType(0), Limits::denorm_min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    CHECK(inverse_power_of_two(a) > 0);
    CHECK(inverse_power_of_two(a) < Limits::infinity());
  }
  CHECK(Limits::max() * inverse_power_of_two(Limits::max()) < 8);
}

TEMPLATE_TEST_CASE("lerp: exact at both ends, of one sign between", "", float, double) {
  bench::Random random(3, 0);
  for (int n = 0; n < 10'000; ++n) {
    const auto a = static_cast<TestType>(random.sign() * std::exp2(random.uniform(-20, 20)));
    const auto b = static_cast<TestType>(random.sign() * std::exp2(random.uniform(-20, 20)));
    const auto t = static_cast<TestType>(random.uniform());
    REQUIRE(lerp(a, b, TestType(0)) == a);
    REQUIRE(lerp(a, b, TestType(1)) == b);
    if (negative(a) == negative(b)) REQUIRE(negative(lerp(a, b, t)) == negative(a));
  }
}

TEMPLATE_TEST_CASE("signs are sign bits; min and max return the second operand beside a NaN", "", float,
                   double) {
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  CHECK(negative(-TestType(0)));
  CHECK_FALSE(negative(TestType(0)));
  CHECK(min(nan, TestType(2)) == 2);
  CHECK(max(nan, TestType(2)) == 2);
  CHECK(std::isnan(min(TestType(2), nan)));
  CHECK(clamp01(TestType(-3)) == 0);
  CHECK(clamp01(TestType(3)) == 1);
  CHECK(std::signbit(isocast::copysign(TestType(2), -TestType(0))));
}
