// Intervals against Arb: containment, decorations, monotony, tightness.
#include <math/random_expression.h>
#include <test_size.h>

#include <catch2/catch.hpp>

using namespace isocast;
using namespace isocast::test;

namespace {

template <class T> Interval<T> interval(const Range<T>& range) { return {range.lo, range.hi}; }

constexpr int kExponents[] = {0, 1, 2, 3, 4, 5, 8, 17, 500, -1, -2, -3, -4};
int any_exponent(bench::Random& random) { return kExponents[random.below(13)]; }

template <class T> bool contains(const Interval<T>& a, const Ball& x) {
  return !x.outside(static_cast<double>(a.lo), static_cast<double>(a.hi));
}
template <class T> bool well_formed(const Interval<T>& a) {
  constexpr T largest = kLargest<T>;
  return (a.empty || a.lo <= a.hi) && a.lo <= largest && a.hi >= -largest && (!a.continuous || a.defined) &&
         !(a.empty && a.defined);
}

}  // namespace

TEMPLATE_TEST_CASE("an interval holds the value of every operation at every point", "[property]", float,
                   double) {
  for (int op = 0; op < kInclusionCount; ++op) {
    const Inclusion operation = static_cast<Inclusion>(op);
    std::int64_t decided = 0;
    const std::int64_t count = cases(100'000, 10'000'000);
    for (std::int64_t i = 0; i < count; ++i) {
      bench::Random random(op, i);
      const Range<TestType> a = any_range<TestType>(random), b = any_range<TestType>(random);
      const TestType x = any_member(random, a), z = any_member(random, b);
      const int n = any_exponent(random);
      const Interval<TestType> y = apply(operation, interval(a), interval(b), n);
      const Ball value = truth(operation, Ball(x), Ball(z), n);
      // without a value the interval must not claim one; with one it holds it
      const bool right = well_formed(y) && (value.is_number() ? !y.empty && contains(y, value) : !y.defined);
      decided += value.is_number();
      if (right) continue;
      INFO("operation " << op << " n " << n << " case " << i << " at " << x << ", " << z);
      INFO("in [" << a.lo << ", " << a.hi << "], [" << b.lo << ", " << b.hi << "]");
      FAIL_CHECK("[" << y.lo << ", " << y.hi << "] " << y.defined << y.continuous << y.empty);
      break;
    }
    CHECK(decided > count / 8);
  }
}

TEMPLATE_TEST_CASE("an interval holds the value of random formulas", "[property]", float, double) {
  std::int64_t decided = 0;
  const std::int64_t count = cases(100'000, 10'000'000);
  for (std::int64_t i = 0; i < count; ++i) {
    bench::Random random(100, i);
    const RandomExpression expression(random);
    const Range<TestType> a = moderate_range<TestType>(random), b = moderate_range<TestType>(random);
    const TestType x = any_member(random, a), z = any_member(random, b);
    const Interval<TestType> y = expression.value(interval(a), interval(b));
    const Ball value = expression.truth_at(Ball(x), Ball(z));
    decided += value.is_number();
    if (well_formed(y) && (!value.is_number() || (!y.empty && contains(y, value)))) continue;
    FAIL("case " << i << " at " << x << ", " << z << ": [" << y.lo << ", " << y.hi << "]");
  }
  CHECK(decided > count / 4);
}

TEMPLATE_TEST_CASE("a part of a box has a part of the interval, no worse decorated", "[property]", float,
                   double) {
  for (int op = 0; op < kInclusionCount; ++op) {
    const Inclusion operation = static_cast<Inclusion>(op);
    if (operation == Inclusion::chebyshev) continue;  // cos(n acos(a)) is not monotone in its last digits
    for (std::int64_t i = 0; i < 20'000; ++i) {
      bench::Random random(200 + op, i);
      const Range<TestType> a = any_range<TestType>(random), b = any_range<TestType>(random);
      const TestType p = any_member(random, a), q = any_member(random, a), r = any_member(random, b);
      const int n = any_exponent(random);
      const Interval<TestType> whole = apply(operation, interval(a), interval(b), n);
      const Interval<TestType> part =
          apply(operation, interval(Range<TestType>{std::min(p, q), std::max(p, q)}),
                interval(Range<TestType>{r, r}), n);
      // the library's functions are not monotone in their last digit, nor where they begin to overflow
      const TestType overflow = down_library(kInfinity<TestType>);
      const bool inside = part.empty || (part.lo >= std::min(down_library(whole.lo), overflow) &&
                                         part.hi <= std::max(up_library(whole.hi), -overflow));
      const bool decorated = (part.defined || !whole.defined) && (part.continuous || !whole.continuous) &&
                             (part.empty || !whole.empty);
      if (inside && decorated) continue;
      INFO("operation " << op << " n " << n << " of [" << a.lo << ", " << a.hi << "] at " << p << ", " << q);
      FAIL_CHECK("[" << part.lo << ", " << part.hi << "] in [" << whole.lo << ", " << whole.hi << "]");
      break;
    }
  }
}

TEMPLATE_TEST_CASE("an interval is hardly wider than the values", "", float, double) {
  using I = Interval<TestType>;
  const TestType spacing = kSpacing<TestType>;
  for (int op = 0; op < kInclusionCount; ++op) {
    const Inclusion operation = static_cast<Inclusion>(op);
    CAPTURE(op);
    // points: a few digits; boxes without an extremum or a jump: those of the corners
    const I point = apply(operation, I(TestType(0.375)), I(TestType(1.25)), 3);
    const TestType size = std::max(std::abs(point.lo), std::abs(point.hi));
    CHECK(std::isfinite(point.hi - point.lo));
    CHECK(point.hi - point.lo <= 24 * spacing * std::max(size, TestType(1)));
    const I box = apply(operation, I(TestType(0.25), TestType(0.45)), I(TestType(1.25), TestType(1.5)), 3);
    TestType lo = kInfinity<TestType>, hi = -lo;
    for (const double x : {0.25, 0.45})
      for (const double z : {1.25, 1.5}) {
        const I corner = apply(operation, I(static_cast<TestType>(x)), I(static_cast<TestType>(z)), 3);
        lo = std::min(lo, corner.lo), hi = std::max(hi, corner.hi);
      }
    CHECK(std::isfinite(box.hi - box.lo));
    CHECK(box.hi - box.lo <= (hi - lo) + 32 * spacing * std::max(hi, TestType(1)));
    CHECK(box.continuous);
  }
}
