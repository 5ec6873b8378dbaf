// What intervals and affine forms say about a function beyond its bounds, and how constants enter.
#include <math/ball.h>
#include <math/inclusion_operations.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;

namespace {

enum class Decoration { empty, undefined, defined, continuous };

template <class F> Decoration decoration_of(const F& a) {
  if (a.empty) return Decoration::empty;
  return a.continuous ? Decoration::continuous : a.defined ? Decoration::defined : Decoration::undefined;
}

template <class R> AffineForm<R, 1> form_of(const Interval<R>& a) {
  return affine_argument<R, 1>(a.lo, a.hi, 0);
}

// The decoration of f over [lo, hi]; a form, whose ranges are a little wider, may know less.
template <class R, class F> void check(F f, double lo, double hi, Decoration expected) {
  const Interval<R> a(static_cast<R>(lo), static_cast<R>(hi));
  CAPTURE(lo, hi);
  CHECK(decoration_of(f(a)) == expected);
  CHECK(decoration_of(f(form_of(a))) <= std::max(expected, Decoration::undefined));
}

}  // namespace

TEMPLATE_TEST_CASE("poles, jumps and edges of domains are never called continuous", "", float, double) {
  using enum Decoration;
  const auto run = [](auto f, double lo, double hi, Decoration expected) {
    check<TestType>(f, lo, hi, expected);
  };
  run([](const auto& a) { return sqrt(a); }, -1, 2, undefined);
  run([](const auto& a) { return sqrt(a); }, -2, -1, empty);
  run([](const auto& a) { return sqrt(a); }, 0, 2, continuous);
  run([](const auto& a) { return log(a); }, 0, 2, undefined);
  run([](const auto& a) { return log(a); }, -1, 0, empty);
  run([](const auto& a) { return log10(a); }, 1, 2, continuous);
  run([](const auto& a) { return power(a, -1); }, -1, 1, undefined);
  run([](const auto& a) { return power(a, -2); }, 0, 1, undefined);
  run([](const auto& a) { return power(a, -2); }, 1, 2, continuous);
  run([](const auto& a) { return a / a; }, -1, 1, undefined);
  run([](const auto& a) { return tan(a); }, 1, 2, undefined);
  run([](const auto& a) { return tan(a); }, -1, 1, continuous);
  run([](const auto& a) { return asin(a); }, 0.5, 1.5, undefined);
  run([](const auto& a) { return acos(a); }, 1.5, 2, empty);
  run([](const auto& a) { return floor(a); }, 0.5, 1.5, defined);
  run([](const auto& a) { return floor(a); }, 0.25, 0.75, continuous);
  run([](const auto& a) { return ceil(a); }, 0.5, 1, continuous);
  run([](const auto& a) { return round(a); }, 0, 0.5, defined);
  run([](const auto& a) { return sign(a); }, -1, 1, defined);
  run([](const auto& a) { return abs(a); }, -1, 1, continuous);
  run([](const auto& a) { return atan2(a, a); }, -1, 1, defined);
  run([](const auto& a) { return atan2(a, abs(a)); }, 1, 2, continuous);
  run([](const auto& a) { return pow(a, a); }, -1, 1, undefined);
  run([](const auto& a) { return pow(a, a); }, 1, 2, continuous);
  run([](const auto& a) { return mod(a, a); }, -1, 1, undefined);
  run([](const auto& a) { return step(a, a); }, 0, 1, defined);
  // what went wrong inside is not forgotten
  run([](const auto& a) { return square(sqrt(a)); }, -1, 2, undefined);
  run([](const auto& a) { return exp(sqrt(a)) + a; }, -2, -1, empty);
  run([](const auto& a) { return sin(floor(a)); }, 0.5, 1.5, defined);
}

TEMPLATE_TEST_CASE("a branch that is not taken need not be defined", "", float, double) {
  using I = Interval<TestType>;
  const auto f = [](const I& a) { return choose(step(I(TestType(0)), a), sqrt(a), -a); };
  CHECK(decoration_of(f(I(1, 2))) == Decoration::continuous);
  CHECK(decoration_of(f(I(-2, -1))) == Decoration::continuous);
  CHECK(f(I(-2, -1)).lo == 1);
  const I both = f(I(-1, 4));
  CHECK(decoration_of(both) == Decoration::undefined);
  CHECK(both.lo == -4);
  CHECK(both.hi >= 2);
}

TEMPLATE_TEST_CASE("NaN never rejects; infinities stay on their side", "", float, double) {
  using I = Interval<TestType>;
  using Limits = std::numeric_limits<TestType>;
  for (const TestType x : {TestType(-1), TestType(0), Limits::max(), Limits::infinity(), Limits::quiet_NaN()})
    for (int op = 0; op < test::kInclusionCount; ++op) {
      CAPTURE(op, x);
      const I nan(Limits::quiet_NaN(), x), y = apply(static_cast<test::Inclusion>(op), nan, I(x), 3);
      CHECK_FALSE(nan.defined);
      CHECK_FALSE(y.defined);
      CHECK_FALSE(std::isnan(y.lo));
      CHECK_FALSE(std::isnan(y.hi));
    }
  CHECK_FALSE(excludes_zero(I(Limits::quiet_NaN())));
  CHECK(I(Limits::infinity()).lo == Limits::max());
  const I overflow = exp(I(TestType(10'000)));
  CHECK(overflow.hi == Limits::infinity());
  CHECK(overflow.lo < Limits::infinity());
  const I inverse = I(TestType(1)) / overflow;
  CHECK(inverse.hi > 0);
  const AffineForm<TestType, 1> lost = exp(affine_argument<TestType, 1>(0, 10'000, 0));
  CHECK(std::isinf(lost.r));
  CHECK_FALSE(excludes_zero(interval_of(lost)));
}

TEMPLATE_TEST_CASE("constants enter as outward intervals", "", float, double) {
  const auto third = enclosed<TestType>(1.0 / 3, false);
  CHECK(3 * static_cast<long double>(third.lo) < 1);
  CHECK(3 * static_cast<long double>(third.hi) > 1);
  CHECK(third.hi - third.lo <= 2 * kSpacing<TestType>);
  CHECK(enclosed<TestType>(0.5, true).lo == TestType(0.5));
  CHECK(enclosed<TestType>(0.5, true).hi == TestType(0.5));
  CHECK(enclosed<TestType>(1e300, true).hi >= TestType(1e30));
  CHECK(static_cast<double>(enclosed<TestType>(1e300, true).lo) <= 1e300);
  CHECK(enclosed<TestType>(5e-324, false).lo <= 0);
  CHECK(enclosed<TestType>(5e-324, false).hi > 0);
  test::Ball pi;
  arb_const_pi(pi.set(), 200);
  const auto interval = pi_interval<TestType>();
  CHECK_FALSE(pi.outside(static_cast<double>(interval.lo), static_cast<double>(interval.hi)));
}
