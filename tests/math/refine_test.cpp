// Bracketed root refinement, one lane.
#include <isocast/math/refine.h>

#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;

namespace {

template <class F> Bracket<double> bracket_of(F f) { return {0, 1, f(0.0), f(1.0)}; }

}  // namespace

TEST_CASE("regula falsi is exact for lines, and stays in the bracket") {
  const auto line = [](double s) { return 3 * s - 1; };
  Bracket<double> b = bracket_of(line);
  CHECK(regula_falsi(line, b, 1) == Approx(1.0 / 3).epsilon(1e-15));
  const Bracket<double> nothing_left = {0.25, 0.75, -0.0, 0.0};
  CHECK((chord_zero(nothing_left) >= 0.25 && chord_zero(nothing_left) <= 0.75));
}

TEST_CASE("bisection halves, and is off by half of what is left at most") {
  const auto f = [](double s) { return s * s * s - 0.2; };
  for (const int n : {1, 5, 20}) {
    Bracket<double> b = bracket_of(f);
    const double s = bisect(f, b, n);
    CHECK(b.hi - b.lo == std::ldexp(1.0, -n));
    CHECK(std::abs(s - std::cbrt(0.2)) <= std::ldexp(1.0, -n - 1));
  }
}

TEST_CASE("adaptive regula falsi stops where steps are small") {
  const auto f = [](double s) { return s * s + s - 0.5; };
  Bracket<double> b = bracket_of(f);
  CHECK(regula_falsi_adaptive(f, b, 1e-12, true) == Approx((std::sqrt(3.0) - 1) / 2).margin(1e-11));
}

TEST_CASE("bracketed Newton: within two tolerances, in a bracket of three, however the function is scaled") {
  constexpr double kTolerance = 0x1p-46;
  const auto check = [&](auto f, auto df, double root) {
    Bracket<double> b = bracket_of(f);
    const double s = newton_bracketed(f, df, b, kTolerance, true);
    CAPTURE(root, s, b.lo, b.hi);
    CHECK(std::abs(s - root) <= 2 * kTolerance);
    CHECK(b.hi - b.lo <= 3 * kTolerance);
    CHECK((b.lo <= s && s <= b.hi));
    CHECK(negative(b.flo) != negative(b.fhi));
  };
  check([](double s) { return s - 0.3; }, [](double) { return 1.0; }, 0.3);
  check([](double s) { return s * s * s - 0.2; }, [](double s) { return 3 * s * s; }, std::cbrt(0.2));
  // a root next to the entry, where the chord starts far away: every step but the last is a halving
  for (const double root : {1e-7, 1e-9, 1e-12}) {
    const auto f = [=](double s) { return s < root ? (s - root) * 1e-20 : s - root; };
    check(
        f, [=](double s) { return s < root ? 1e-20 : 1.0; }, root);
    const auto steep = [=](double s) { return s * s * s * 1e30 - root * root * root * 1e30; };
    check(
        steep, [](double s) { return 3e30 * s * s; }, root);
  }
  // a triple root: Newton's steps shrink by a third only
  const auto cubed = [](double s) { return (s - 0.4) * (s - 0.4) * (s - 0.4); };
  check(
      cubed, [](double s) { return 3 * (s - 0.4) * (s - 0.4); }, 0.4);
}

TEST_CASE("a lane outside `active` keeps its bracket") {
  const auto f = [](double s) { return s - 0.3; };
  Bracket<double> b = bracket_of(f);
  newton_bracketed(
      f, [](double) { return 1.0; }, b, 1e-12, false);
  CHECK(b.lo == 0);
  CHECK(b.hi == 1);
}
