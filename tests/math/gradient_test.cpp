// Gradients: inclusions of derivatives hold every difference quotient, and numbers are near one.
#include <math/random_expression.h>
#include <test_size.h>

#include <catch2/catch.hpp>

using namespace isocast;
using namespace isocast::test;

namespace {

// (f(x + h) - f(x)) / h, with f of the second argument y held fixed.
Ball difference_quotient(const RandomExpression& f, double x, double h, double y) {
  const Ball low = f.truth_at(Ball(x), Ball(y)), high = f.truth_at(Ball(x + h), Ball(y));
  return truth(Inclusion::divide, truth(Inclusion::subtract, high, low, 0), Ball(h), 0);
}

template <class T> Interval<T> range_of(const Interval<T>& a) { return a; }
template <class T, int N> Interval<T> range_of(const AffineForm<T, N>& a) { return interval_of(a); }

// By the mean value theorem, also with edges: wherever f is continuous and its derivative is enclosed.
template <class F, class Make> void check_mean_values(Make make) {
  std::int64_t decided = 0;
  const std::int64_t count = cases(50'000, 1'000'000);
  for (std::int64_t i = 0; i < count; ++i) {
    bench::Random random(300, i);
    const RandomExpression f(random);
    const double lo = random.uniform(-2, 2), width = std::exp2(random.below(12) - 12),
                 y = random.uniform(-2, 2);
    const F zero(0), one(1);
    const Gradient<F> g =
        f.value(Gradient<F>(make(lo, lo + width), one, zero, zero), Gradient<F>(make(y, y), zero, one, zero));
    const auto value = range_of(g.value), slope = range_of(g.dx);
    if (!value.continuous || !slope.defined) continue;
    const double x = lo + random.uniform(0, 0.5) * width, h = random.uniform(0.1, 0.5) * width;
    const Ball quotient = difference_quotient(f, x, (x + h) - x, y);
    decided += quotient.is_number();
    if (!quotient.is_number() ||
        !quotient.outside(static_cast<double>(slope.lo), static_cast<double>(slope.hi)))
      continue;
    FAIL("case " << i << " in [" << lo << ", " << lo + width << "], " << y << ": [" << slope.lo << ", "
                 << slope.hi << "]");
  }
  CHECK(decided > count / 4);
}

}  // namespace

TEST_CASE("an interval's gradient holds every difference quotient", "[property]") {
  check_mean_values<Interval<double>>([](double lo, double hi) { return Interval<double>(lo, hi); });
}

TEST_CASE("an affine form's gradient holds every difference quotient", "[property]") {
  check_mean_values<AffineForm<double, 1>>(
      [](double lo, double hi) { return affine_argument<double, 1>(lo, hi, 0); });
}

TEST_CASE("the gradient of every operation on numbers is near the difference quotient") {
  const double x = 0.4, y = 1.25, h = 0x1p-30;
  const Gradient<double> a(x, 1, 0, 0), b(y, 0, 1, 0);
  for (int op = 0; op < kInclusionCount; ++op) {
    const Inclusion operation = static_cast<Inclusion>(op);
    CAPTURE(op);
    const Gradient<double> g = apply(operation, a, b, 3);
    const auto f = [&](double p, double q) { return apply(operation, p, q, 3); };
    CHECK(g.value == f(x, y));
    CHECK(g.dx == Approx((f(x + h, y) - f(x - h, y)) / (2 * h)).margin(1e-6).epsilon(1e-6));
    CHECK(g.dy == Approx((f(x, y + h) - f(x, y - h)) / (2 * h)).margin(1e-6).epsilon(1e-6));
    CHECK(g.dz == 0);
  }
}

TEST_CASE("derivatives beside edges and jumps say so") {
  using I = Interval<double>;
  const auto along_x = [](double lo, double hi) { return Gradient<I>(I(lo, hi), I(1), I(0), I(0)); };
  const Gradient<I> edge = abs(along_x(-1, 2)), smooth = abs(along_x(1, 2)), jump = floor(along_x(0.5, 1.5));
  CHECK(edge.dx.lo <= -1);
  CHECK(edge.dx.hi >= 1);
  CHECK(edge.value.continuous);
  CHECK_FALSE(edge.dx.continuous);
  CHECK(smooth.dx.lo > 0.999);
  CHECK(smooth.dx.continuous);
  CHECK_FALSE(jump.dx.defined);
  CHECK(floor(along_x(0.25, 0.5)).dx.continuous);
  CHECK_FALSE(sqrt(along_x(0, 1)).dx.defined);
}
