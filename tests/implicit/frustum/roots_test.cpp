// Root finders of Bernstein polynomials, held against polynomials whose roots are known.
#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/row_roots.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace isocast;

namespace {

constexpr RootFinder kFinders[] = {RootFinder::lr,      RootFinder::mr,        RootFinder::lr_mult,
                                   RootFinder::mr_mult, RootFinder::schneider, RootFinder::clip,
                                   RootFinder::signs};

// The polynomial with these roots and no others that are real: a product of lines and of parabolas above
// zero.
Bezier<double> product(const std::vector<double>& roots, int pairs, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> c = {random() % 2 ? 1.0 : -1.0};
  const auto times = [&c](const std::vector<double>& factor) {
    // Bernstein coefficients of a product are binomially weighted sums
    const int m = static_cast<int>(c.size()) - 1, n = static_cast<int>(factor.size()) - 1;
    const auto choose = [](int a, int b) {
      return std::round(std::exp(std::lgamma(a + 1) - std::lgamma(b + 1) - std::lgamma(a - b + 1)));
    };
    std::vector<double> result(static_cast<std::size_t>(m + n) + 1, 0.0);
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j)
        result[static_cast<std::size_t>(i + j)] += choose(m, i) * choose(n, j) / choose(m + n, i + j) *
                                                   c[static_cast<std::size_t>(i)] *
                                                   factor[static_cast<std::size_t>(j)];
    c = result;
  };
  for (const double root : roots) times({-root, 1 - root});
  for (int k = 0; k < pairs; ++k) {
    const double centre = 2 * unit(random) - 0.5, height = 0.01 + unit(random);
    // (x - centre)^2 + height
    times(
        {centre * centre + height, centre * centre - centre + height, (1 - centre) * (1 - centre) + height});
  }
  Bezier<double> p;
  p.degree = static_cast<int>(c.size()) - 1;
  std::ranges::copy(c, p.c);
  return p;
}

FirstRoot<double> find(const Bezier<double>& p, RootFinder finder, double eps, bool value = false) {
  return find_first(p, BezierValues<double>(p), FinderOptions{finder, eps, value, 64}, eps, Doubt<double>{},
                    true);
}

}  // namespace

TEST_CASE("every finder reports the smallest root of simple ones", "[property]") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 20000; ++n) {
    const int count = static_cast<int>(random() % 5), pairs = static_cast<int>(random() % 4);
    if (count + pairs == 0) continue;
    std::vector<double> roots;
    for (int i = 0; i < count; ++i) roots.push_back(1.2 * unit(random) - 0.1);
    std::ranges::sort(roots);
    bool apart = true;
    for (std::size_t i = 1; i < roots.size(); ++i) apart = apart && roots[i] - roots[i - 1] > 0.03;
    std::erase_if(roots, [](double r) { return r > -1e-3 && r < 1e-3; });
    if (!apart) continue;
    const Bezier<double> p = product(roots, pairs, random);
    const auto first = std::ranges::find_if(roots, [](double r) { return r >= 0; });
    const bool found = first != roots.end() && *first < 1 - 1e-3;
    if (first != roots.end() && !found && *first <= 1 + 1e-3) continue;
    for (const RootFinder finder : kFinders)
      for (const bool value : {false, true}) {
        const double eps = 1e-6;
        const FirstRoot<double> root = find(p, finder, eps, value);
        INFO("finder " << int(finder) << " degree " << p.degree << " value " << value << " first "
                       << (found ? *first : -1.0));
        REQUIRE(root.hit == found);
        // clipping from one side may creep
        if (finder == RootFinder::clip && root.open) continue;
        REQUIRE_FALSE(root.open);
        if (found) REQUIRE(std::abs(root.s - *first) < (value ? 2e-6 : 1e-6));
      }
  }
}

TEST_CASE("no sign change of the coefficients, no root; a root at 0 or 1 is found") {
  for (const RootFinder finder : kFinders) {
    INFO("finder " << int(finder));
    CHECK_FALSE(find(Bezier<double>{3, {1, 0, 2, 5}}, finder, 1e-6).hit);
    CHECK_FALSE(find(Bezier<double>{3, {-1, -1e-300, -2, -5}}, finder, 1e-6).hit);
    const FirstRoot<double> line = find(Bezier<double>{1, {-1, 3}}, finder, 1e-6);
    CHECK(line.hit);
    CHECK(line.s == Approx(0.25));
    const FirstRoot<double> start = find(Bezier<double>{2, {-1e-9, 1, 2}}, finder, 1e-6);
    CHECK(start.hit);
    CHECK(start.s < 1e-6);
    // values so small that their product would be zero
    CHECK(find(Bezier<double>{2, {-1e-200, 1e-200, 1e-200}}, finder, 1e-6).hit);
  }
}

TEST_CASE("double roots of quintics take few steps where the step is lengthened") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  double steps[2] = {};
  int hits = 0;
  for (int n = 0; n < 2000; ++n) {
    const double root = 0.2 + 0.6 * unit(random);
    // pushed across zero by a hair, so that there is a pair of roots
    Bezier<double> p = product({root, root, -0.3, 1.4, 1.6}, 0, random);
    const double sign = p.c[0] > 0 ? -1 : 1, push = 1e-9 * p.largest();
    for (int k = 0; k <= 5; ++k) p.c[k] += sign * push;
    const FirstRoot<double> plain = find(p, RootFinder::lr, 5e-4),
                            longer = find(p, RootFinder::lr_mult, 5e-4);
    if (!plain.hit || !longer.hit) continue;
    ++hits;
    REQUIRE(std::abs(plain.s - root) < 2e-3);
    REQUIRE(std::abs(longer.s - root) < 2e-3);
    steps[0] += plain.steps, steps[1] += longer.steps;
  }
  CHECK(hits > 1900);
  CHECK(steps[1] < 0.8 * steps[0]);
}

TEST_CASE("knots converge faster than subdivisions, halving is slowest") {
  std::mt19937_64 random(7);
  double steps[6] = {};
  for (int n = 0; n < 3000; ++n) {
    const Bezier<double> p = product({0.3 + 0.0001 * (n % 1000), 0.8}, 3, random);
    for (int f = 0; f < 6; ++f) steps[f] += find(p, kFinders[f], 5e-4).steps;
  }
  // a subdivision is as many knots as the degree
  CHECK(steps[1] < 8 * steps[0]);
  CHECK(steps[0] < steps[4]);
}

TEST_CASE("what is proved of a polynomial is true, and its bracket holds the root", "[property]") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0, 1), around(-1, 1);
  int proved_hits = 0, proved_misses = 0;
  for (int n = 0; n < 20000; ++n) {
    std::vector<double> roots;
    for (std::uint64_t i = random() % 4; i > 0; --i) roots.push_back(1.4 * unit(random) - 0.2);
    std::ranges::sort(roots);
    const Bezier<double> exact = product(roots, 1 + static_cast<int>(random() % 3), random);
    const double margin = std::pow(10.0, -2 - 10 * unit(random)) * exact.largest();
    RowPolynomials<double> row = {};
    row.degree = exact.degree, row.margin[0] = margin, row.proves = true;
    row.eps[0] = 1e-4;
    for (int k = 0; k <= exact.degree; ++k) row.c[k][0] = exact.c[k] + 0.999 * margin * around(random);
    RowRoots found;
    find_row<double>(row, {RootFinder::lr, 1e-4, false, 64}, 1, found);
    if ((found.proved & 1) == 0) continue;
    const auto first = std::ranges::find_if(roots, [](double r) { return r >= 0 && r <= 1; });
    INFO("degree " << exact.degree << " margin " << margin);
    if ((found.hit & 1) != 0) {
      ++proved_hits;
      REQUIRE(first != roots.end());
      REQUIRE(found.lo[0] <= *first + 1e-12);
      REQUIRE(found.hi[0] >= *first - 1e-12);
    } else {
      ++proved_misses;
      REQUIRE(first == roots.end());
    }
  }
  CHECK(proved_hits > 3000);
  CHECK(proved_misses > 3000);
}

TEST_CASE("collocation inverts, and Chebyshev's points are better conditioned than even ones") {
  for (int degree : {1, 3, 8, 18, 24}) {
    const Collocation& nodes = collocation(degree);
    const auto n = static_cast<std::size_t>(degree) + 1;
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> b(n), values(n);
    double size = 0, off = 0;
    for (double& c : b) c = unit(random);
    std::vector<double> row(n);
    for (std::size_t j = 0; j < n; ++j) {
      bernstein_values(degree, nodes.points[j], row.data());
      values[j] = 0;
      for (std::size_t i = 0; i < n; ++i) values[j] += row[i] * b[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      double c = 0;
      for (std::size_t j = 0; j < n; ++j)
        c += nodes.from_values[i * n + j] * values[j],
            size = std::max(size, std::abs(nodes.from_values[i * n + j]));
      off = std::max(off, std::abs(c - b[i]));
    }
    INFO("degree " << degree << " largest entry " << size);
    CHECK(off < 1e-15 * size * double(n));
  }
}
