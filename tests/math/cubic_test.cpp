// Cubics: both forms, their derivatives and where they turn.
#include <isocast/apps/bench/random.h>
#include <isocast/math/cubic.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;

namespace {

BernsteinCubic<double> any_cubic(bench::Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

long double exact(const BernsteinCubic<double>& p, long double s) {
  const long double r = 1 - s;
  return p.c0 * r * r * r + 3 * p.c1 * r * r * s + 3 * p.c2 * r * s * s + p.c3 * s * s * s;
}

}  // namespace

TEST_CASE("both forms have the same values") {
  bench::Random random(4, 0);
  for (int n = 0; n < 2000; ++n) {
    const BernsteinCubic<double> p = any_cubic(random);
    const PowerCubic<double> q = power_form(p);
    const double s = random.uniform(), h = 1e-6;
    REQUIRE(std::abs(eval(p, s) - exact(p, s)) <= 8 * 0x1p-53);
    REQUIRE(std::abs(eval(q, s) - exact(p, s)) <= 128 * 0x1p-53);
    REQUIRE(eval_derivative(p, s) == Approx(eval_derivative(q, s)).margin(1e-13));
    REQUIRE(eval_derivative(p, s) ==
            Approx(double(exact(p, s + h) - exact(p, s - h)) / (2 * h)).margin(1e-9));
    REQUIRE(value_at_0(p) == eval(p, 0.0));
    REQUIRE(value_at_1(p) == eval(p, 1.0));
    REQUIRE(value_at_0(q) == eval(q, 0.0));
    REQUIRE(value_at_1(q) == eval(q, 1.0));
  }
}

TEST_CASE("a coefficient that underflowed keeps its sign at the ends") {
  const BernsteinCubic<float> p = {-0.0f, 0.0f, 0.0f, 0.0f};
  CHECK(negative(value_at_0(p)));
  CHECK_FALSE(negative(value_at_1(p)));
}

TEST_CASE("extrema are where the derivative vanishes, in order") {
  bench::Random random(5, 0);
  int two = 0;
  for (int n = 0; n < 2000; ++n) {
    const BernsteinCubic<double> p = any_cubic(random);
    const Extrema<double> e = extrema(p), f = extrema(power_form(p));
    if (std::isnan(e.first)) continue;
    ++two;
    REQUIRE(e.first <= e.second);
    for (const double s : {e.first, e.second})
      if (std::abs(s) < 2) REQUIRE(std::abs(eval_derivative(p, s)) < 1e-12);
    if (e.first > 0 && e.first < 1 && std::abs(e.second - e.first) > 1e-3)
      REQUIRE(f.first == Approx(e.first).epsilon(1e-9));
  }
  CHECK(two > 500);
}

TEST_CASE("extrema of quadratics, lines and huge and tiny cubics") {
  // (s - 1/4)^2: one extremum, the other is nowhere
  const Extrema<double> e =
      extrema(BernsteinCubic<double>{0.0625, 0.0625 - 0.5 / 3, 0.0625 - 1.0 / 3 + 1.0 / 3, 0.5625});
  CHECK((std::abs(e.first - 0.25) < 1e-14 || std::abs(e.second - 0.25) < 1e-14));
  // a line turns nowhere inside
  const Extrema<double> line = extrema(BernsteinCubic<double>{0, 1, 2, 3});
  for (const double s : {line.first, line.second}) CHECK_FALSE((s > 0 && s < 1));
  // scaling by powers of two changes no bit
  const BernsteinCubic<double> p = {-1, 2, -2, 1};
  const Extrema<double> middle = extrema(p);
  for (const double scale : {0x1p-900, 0x1p900}) {
    const Extrema<double> scaled =
        extrema(BernsteinCubic<double>{p.c0 * scale, p.c1 * scale, p.c2 * scale, p.c3 * scale});
    CHECK(scaled.first == middle.first);
    CHECK(scaled.second == middle.second);
  }
}
