// Chebyshev series across and Bernstein form along: interpolation, halves, cuts, bounds.
#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/padua.h>
#include <isocast/implicit/frustum/patch.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace isocast;

namespace {

struct Random {
  std::mt19937_64 bits{17};
  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(bits); }
};

// T_0(x) ... T_degree(x)
std::vector<double> series(int degree, double x) {
  std::vector<double> values(static_cast<std::size_t>(degree) + 1), slopes(values.size());
  chebyshev_values(degree, x, values.data(), slopes.data());
  return values;
}

struct Form {
  PatchShape shape;
  std::vector<double> b;

  Form(PatchShape s, Random& random) : shape(s), b(static_cast<std::size_t>(s.size()), 0.0) {
    // terms that get smaller, as those of smooth functions do
    for (int j = 0; j <= shape.across; ++j)
      for (int i = 0; i + j <= shape.across; ++i)
        for (int k = 0; k <= shape.along; ++k) at(i, j)[k] = random(-1, 1) * std::pow(0.4, i + j);
  }
  double* at(int i, int j) { return b.data() + shape.pair(i, j) * shape.row(); }
  [[nodiscard]] double operator()(double u, double v, double w) const {
    const std::vector<double> in_u = series(shape.across, u), in_v = series(shape.across, v);
    std::vector<double> in_w(static_cast<std::size_t>(shape.along) + 1);
    bernstein_values(shape.along, w, in_w.data());
    double sum = 0;
    for (std::size_t j = 0; j < in_v.size(); ++j)
      for (std::size_t i = 0; i + j < in_u.size(); ++i) {
        const double* const row =
            b.data() + shape.pair(static_cast<int>(i), static_cast<int>(j)) * shape.row();
        for (std::size_t k = 0; k < in_w.size(); ++k) sum += in_u[i] * in_v[j] * in_w[k] * row[k];
      }
    return sum;
  }
};

// The sum of the sizes of a polynomial's shares at (x, y) by one value at each Padua point.
double lebesgue_function(const Padua& points, int degree, double x, double y) {
  const std::vector<double> in_x = series(degree, x), in_y = series(degree, y);
  const auto n = static_cast<std::size_t>(degree) + 1;
  double sum = 0;
  std::vector<double> below(n);  // shares of a row in the degrees of y up to each
  for (std::size_t j = 0; j <= n; ++j) {
    double run = 0;
    for (std::size_t l = 0; l < n; ++l) below[l] = run += in_y[l] * points.from_rows[l * (n + 1) + j];
    for (std::size_t i = j % 2; i < n; i += 2) {
      double share = 0;
      for (std::size_t k = 0; k < n; ++k)
        share += in_x[k] * points.from_columns[k * n + i] * below[n - 1 - k];
      sum += std::abs(share);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("Padua points tell a polynomial of their total degree") {
  Random random;
  for (int degree = 1; degree <= kMostFormDegree; ++degree) {
    const Padua& points = padua(degree);
    const auto n = static_cast<std::size_t>(degree) + 1;
    const Form f({degree, 0}, random);
    double off = 0;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; k + l < n; ++l) {
        double c = 0;
        for (std::size_t j = 0; j <= n; ++j)
          for (std::size_t i = j % 2; i < n; i += 2)
            c += points.from_rows[l * (n + 1) + j] * points.from_columns[k * n + i] *
                 f(points.columns[i], points.rows[j], 0);
        const int p = f.shape.pair(static_cast<int>(k), static_cast<int>(l));
        off = std::max(off, std::abs(c - f.b[static_cast<std::size_t>(p * f.shape.row())]));
      }
    INFO("degree " << degree);
    CHECK(off < 1e-14);
  }
}

TEST_CASE("the constant of Padua points bounds every polynomial of their degree") {
  // between the n-th of Chebyshev's points in both directions, a polynomial of degree d is at most
  // 1 / cos^2(d pi / 2n) times its largest value there (Ehlich, Zeller 1964)
  for (int degree = 1; degree <= kMostFormDegree; ++degree) {
    const Padua& points = padua(degree);
    const int n = 4 * degree;
    double most = 0;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        most = std::max(most,
                        lebesgue_function(points, degree, std::cos((2 * a + 1) * std::numbers::pi / (2 * n)),
                                          std::cos((2 * b + 1) * std::numbers::pi / (2 * n))));
    const double between = std::cos(degree * std::numbers::pi / (2 * n));
    INFO("degree " << degree);
    CHECK(most / (between * between) <= points.lebesgue);
    CHECK(points.lebesgue < 1.5 * most);
  }
}

TEST_CASE("halves and cuts of a form are the form, and its hull holds it") {
  Random random;
  for (const PatchShape shape : {PatchShape{1, 1}, {3, 7}, {8, 8}, {12, 18}, {24, 24}}) {
    Form whole(shape, random), strip = whole, part = whole;
    const int side_u = random.bits() % 2, side_v = random.bits() % 2;
    halve<1>(strip.b.data(), whole.b.data(), shape, chebyshev_half(side_v).data());
    halve<0>(part.b.data(), strip.b.data(), shape, chebyshev_half(side_u).data());
    const double first = random(0, 0.6), last = random(first + 0.01, 1);
    cut(part.b.data(), shape, first, last);
    Form less = part;
    const double allowed = 0.01, dropped = drop_degrees(less.b.data(), less.shape, allowed);
    CHECK(dropped <= allowed * 1.001);
    double lo[kMostDepths], hi[kMostDepths];
    find_hull(part.b.data(), shape, lo, hi);
    const double most = largest(part.b.data(), shape);
    INFO("degrees " << shape.across << " " << shape.along);
    for (int n = 0; n < 100; ++n) {
      const double u = random(-1, 1), v = random(-1, 1), w = random(0, 1);
      const double f = part(u, v, w);
      REQUIRE(f ==
              Approx(whole((u + 2 * side_u - 1) / 2, (v + 2 * side_v - 1) / 2, first + (last - first) * w))
                  .margin(1e-12 * most));
      REQUIRE(std::abs(less(u, v, w) - f) <= dropped + 1e-13 * most);
      std::vector<double> weights(static_cast<std::size_t>(shape.along) + 1);
      bernstein_values(shape.along, w, weights.data());
      double below = 0, above = 0;
      for (std::size_t k = 0; k < weights.size(); ++k)
        below += weights[k] * lo[k], above += weights[k] * hi[k];
      REQUIRE(below <= f);
      REQUIRE(f <= above);
      REQUIRE(std::abs(f) <= most);
    }
    CHECK((shape.across < 8 || less.shape.across < shape.across));
  }
}

TEST_CASE("the hull of a parabola holds it, however small or large its numbers are") {
  Random random;
  for (const double scale : {1.0, 1e-170, 1e-290, 1e170, 1e290})
    for (int n = 0; n < 200; ++n) {
      Form f({2, 0}, random);
      for (double& c : f.b) c *= scale;
      if (n % 10 == 0) *f.at(2, 0) = 0;
      double lo[kMostDepths], hi[kMostDepths], least = 1e300, most = -1e300;
      find_hull(f.b.data(), f.shape, lo, hi);
      for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j) {
          const double value = f(i / 20.0 - 1, j / 20.0 - 1, 0);
          least = std::min(least, value), most = std::max(most, value);
        }
      const double slack = 1e-13 * scale;
      REQUIRE(lo[0] <= least + slack);
      REQUIRE(hi[0] >= most - slack);
      // all but the mixed term is exact
      const double mixed = 2 * std::abs(*f.at(1, 1)) + 0.01 * scale;
      REQUIRE(lo[0] >= least - mixed);
      REQUIRE(hi[0] <= most + mixed);
    }
}
