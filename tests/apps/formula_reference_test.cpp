// The reference for formulas itself, against roots that are known in closed form, and its two ways against
// each other.
#include <isocast/apps/reference/formula_reference.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/catalogue.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace isocast;
using namespace isocast::reference;

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

FormulaRoots along_x(const char* formula, double t0, double t1, const ReferenceOptions& options = {}) {
  return FormulaReference(parse_expression(formula)).solve({0, 0, 0}, {1, 0, 0}, t0, t1, options);
}
ReferenceOptions balls() {
  ReferenceOptions options;
  options.exact = false;
  return options;
}

struct Expected {
  long double t;
  bool crossing = true;
};
void check_roots(const FormulaRoots& found, const std::vector<Expected>& expected, double width = 1e-11) {
  REQUIRE(found.roots.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // the closed form is itself rounded
    const long double slack = 1e-18L * std::abs(expected[i].t);
    CHECK(found.roots[i].lo <= expected[i].t + slack);
    CHECK(found.roots[i].hi >= expected[i].t - slack);
    CHECK(found.roots[i].hi - found.roots[i].lo <= width);
    CHECK(found.roots[i].crossing == expected[i].crossing);
  }
}
void check_doubt(const FormulaRoots& found, double t, Doubt doubt) {
  REQUIRE(found.doubts.size() == 1);
  CHECK(found.doubts[0].lo <= t);
  CHECK(found.doubts[0].hi >= t);
  CHECK(found.doubts[0].hi - found.doubts[0].lo < 1e-15);
  CHECK(found.doubts[0].doubt == doubt);
}

}  // namespace

TEST_CASE("polynomials: closed forms, in exact arithmetic and in balls") {
  for (const ReferenceOptions& options : {ReferenceOptions(), balls()}) {
    INFO((options.exact ? "exact" : "balls"));
    const FormulaReference sphere(parse_expression("x^2 + y^2 + z^2 - 1.44"));
    check_roots(sphere.solve({-3, 0.5, 0}, {2, 0, 0}, 0, 4, options),
                {{1.5L - std::sqrt(1.19L) / 2}, {1.5L + std::sqrt(1.19L) / 2}});
    CHECK(sphere.solve({-3, 1.25, 0}, {2, 0, 0}, 0, 4, options).roots.empty());
    // decimals are themselves and not the doubles next to them
    check_roots(along_x("x - 0.1", 0, 1, options), {{0.1L}});
    check_roots(along_x("(x - 1)^3", 0, 3, options), {{1}});
    check_roots(along_x("(x - 0.3)*(x - 0.300000001)", 0, 1, options), {{0.3L}, {0.300000001L}});
    check_roots(along_x("x*(x - 1)", 0, 1, options), {{0}, {1}});
    check_roots(along_x("chebyshev(5, x)", -1, 1, options), {{-std::cos(kPi / 10)},
                                                             {-std::cos(3 * kPi / 10)},
                                                             {0},
                                                             {std::cos(3 * kPi / 10)},
                                                             {std::cos(kPi / 10)}});
  }
}

TEST_CASE("touches are found exactly, and suspected in balls") {
  const FormulaRoots touch = along_x("(x - 1/3)^2*(x - 2)", 0, 3);
  CHECK(touch.decided());
  CHECK(touch.bits == 0);
  check_roots(touch, {{1 / 3.0L, false}, {2}});
  check_roots(along_x("(x - 0.5)^2*(x - 0.25)^4*(x^2 - 2)^3", -2, 2),
              {{-std::sqrt(2.0L)}, {0.25L, false}, {0.5L, false}, {std::sqrt(2.0L)}});

  const FormulaRoots suspected = along_x("(x - 1/3)^2*(x - 2)", 0, 3, balls());
  check_roots(suspected, {{2}});
  check_doubt(suspected, 1 / 3.0, Doubt::touch);
  check_doubt(along_x("abs(x - 0.7)", 0, 1), 0.7, Doubt::touch);
  CHECK(along_x("(x - 0.5)^2 + 1e-30", 0, 1, balls()).decided());
}

TEST_CASE("a formula that is iso all along") {
  for (const ReferenceOptions& options : {ReferenceOptions(), balls()})
    for (const char* formula : {"0*x", "x - x", "(x + 1)^2 - x^2 - 2*x - 1", "y*exp(x)"}) {
      INFO(formula);
      const FormulaRoots zero = along_x(formula, 0.25, 2, options);
      CHECK(zero.roots.empty());
      REQUIRE(zero.doubts.size() == 1);
      CHECK(zero.doubts[0].doubt == Doubt::zero);
      CHECK(zero.doubts[0].lo == 0.25);
      CHECK(zero.doubts[0].hi == 2);
    }
  const FormulaRoots half = along_x("max(x, 0)*(x - 1)", -1, 2);
  check_roots(half, {{1}});
  REQUIRE(half.doubts.size() == 1);
  CHECK(half.doubts[0].lo == -1);
  CHECK(half.doubts[0].hi >= 0);
  CHECK(half.doubts[0].hi < 0.025);
}

TEST_CASE("functions: closed forms") {
  check_roots(along_x("sin(x)", 1, 10), {{kPi}, {2 * kPi}, {3 * kPi}}, 1e-10);
  check_roots(along_x("x - pi", 0, 5), {{kPi}});
  check_roots(along_x("x^2 - x - 1 + 0*phi", 0, 5), {{0.5L + std::sqrt(1.25L)}});
  check_roots(along_x("x - phi", 0, 5), {{0.5L + std::sqrt(1.25L)}});
  check_roots(along_x("exp(x) - 2", 0, 1), {{std::numbers::ln2_v<long double>}});
  check_roots(along_x("log(x) + 1", 0.25, 1), {{std::exp(-1.0L)}});
  check_roots(along_x("log10(x) - 0.5", 1, 5), {{std::sqrt(10.0L)}});
  check_roots(along_x("cbrt(x) + 0.5", -1, 1), {{-0.125L}});
  check_roots(along_x("tan(x) - 1", 0, 1.5), {{kPi / 4}});
  check_roots(along_x("asin(x) - 0.5", -1, 1), {{std::sin(0.5L)}});
  check_roots(along_x("acos(x) - 2", -1, 1), {{std::cos(2.0L)}});
  check_roots(along_x("atan(x) + 1", -4, 4), {{-std::tan(1.0L)}});
  check_roots(along_x("atan2(x, 2) - 0.5", -4, 4), {{2 * std::tan(0.5L)}});
  check_roots(along_x("sinh(x) - 2", 0, 4), {{std::asinh(2.0L)}});
  check_roots(along_x("cosh(x) - 2", 0, 4), {{std::acosh(2.0L)}});
  check_roots(along_x("tanh(x) - 0.5", 0, 4), {{std::atanh(0.5L)}});
  check_roots(along_x("pow(x, 2.5) - 3", 1, 4), {{std::pow(3.0L, 0.4L)}});
  check_roots(along_x("min(x - 1, 3 - x)", 0, 4), {{1}, {3}});
  check_roots(along_x("if(x > 1, x - 2, x + 5)", 1.25, 4), {{2}});
}

TEST_CASE("jumps, poles and edges of what is defined are no roots") {
  check_doubt(along_x("1/(x - 0.3)", 0, 1), 0.3, Doubt::undefined);
  check_doubt(along_x("tan(x)", 1, 2), std::numbers::pi / 2, Doubt::undefined);
  check_doubt(along_x("floor(x) - 0.5", 0, 1.7), 1, Doubt::jump);
  check_doubt(along_x("sign(x - 0.3)", 0, 1), 0.3, Doubt::jump);
  check_doubt(along_x("step(0.3, x) - 0.5", 0, 1), 0.3, Doubt::jump);
  check_doubt(along_x("if(x < 0.3, -1, 1)", 0, 1), 0.3, Doubt::jump);
  for (const char* formula :
       {"1/(x - 0.3)", "tan(x + pi/2 - 0.3)", "floor(x + 0.7) - 0.5", "sqrt(x - 0.3)"}) {
    INFO(formula);
    CHECK(along_x(formula, 0, 1).roots.empty());
  }
  const FormulaRoots saw = along_x("mod(x, 1) - 0.5", 0.25, 2.75);
  check_roots(saw, {{0.5L}, {1.5L}, {2.5L}});
  CHECK(saw.doubts.size() == 2);

  const FormulaRoots root = along_x("sqrt(x) - 0.5", -1, 1);
  CHECK(root.decided());
  check_roots(root, {{0.25L}});
  CHECK(along_x("sqrt(x) + 1 + log(-1 - x^2)", -1, 1).decided());
  check_doubt(along_x("sqrt(x - 0.3)", 0, 1), 0.3, Doubt::undefined);
}

TEST_CASE("only the first roots, and no more work than was allowed") {
  ReferenceOptions options;
  for (const bool exact : {true, false}) {
    options.exact = exact;
    options.max_roots = 2;
    const FormulaRoots two = along_x("(x - 0.125)*(x - 0.3)*(x - 0.7)", 0, 1, options);
    check_roots(two, {{0.125L}, {0.3L}});
    CHECK(two.end < 0.31);
  }
  options.max_operations = 1000;
  const FormulaRoots much = along_x("tan(x)*1e-9 + sin(1e9*x) + 2 + 1e-9", 0, 100, options);
  CHECK(much.roots.empty());
  REQUIRE(much.doubts.size() == 1);
  CHECK(much.doubts[0].hi == 100);
  // beyond what is solved exactly
  for (const char* formula : {"x^1000000000 - 2", "2^(2^(2^(2^(2^(2^x)))))", "round(exp(exp(exp(exp(x)))))",
                              "round(exp(-exp(exp(exp(exp(x))))))", "chebyshev(1024, x)*(x - 1)"})
    CHECK(along_x(formula, 0.3, 9, options).roots.size() <= 2);
}

TEST_CASE("the two ways agree on the catalogue's polynomials") {
  std::mt19937_64 random(1);
  int polynomials = 0, roots = 0;
  for (const CatalogueSurface& surface : catalogue()) {
    const FormulaReference f(surface_expression(surface));
    if (!f.polynomial() || *surface.degree > 12) continue;
    ++polynomials;
    INFO(surface.id);
    for (int ray = 0; ray < 5; ++ray) {
      Double3 o, d;
      for (std::size_t a = 0; a < 3; ++a) {
        std::uniform_real_distribution<double> coordinate(surface.domain.lo[a], surface.domain.hi[a]);
        o[a] = coordinate(random);
        d[a] = coordinate(random) - o[a];
      }
      const FormulaRoots exact = f.solve(o, d, -1, 2), ball = f.solve(o, d, -1, 2, balls());
      CHECK(exact.decided());
      CHECK(ball.decided());
      REQUIRE(exact.roots.size() == ball.roots.size());
      for (std::size_t i = 0; i < exact.roots.size(); ++i) {
        CHECK(exact.roots[i].lo <= ball.roots[i].hi);
        CHECK(exact.roots[i].hi >= ball.roots[i].lo);
        CHECK(exact.roots[i].crossing);
        ++roots;
      }
    }
  }
  CHECK(polynomials > 40);
  CHECK(roots > 500);
}

TEST_CASE("chebyshev polynomials are the same in every way they are written") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const char* degree : {"6", "7", "14", "22", "50"}) {
    const std::string id = std::string("chmutov_") + degree;
    INFO(id);
    const FormulaReference composed(surface_expression(require_surface(id))),
        powers(surface_expression(require_surface(id + "_power")));
    REQUIRE(composed.polynomial());
    REQUIRE(powers.polynomial());
    for (int ray = 0; ray < 3; ++ray) {
      const Double3 o = {coordinate(random), coordinate(random), coordinate(random)},
                    d = {coordinate(random), coordinate(random), coordinate(random)};
      const FormulaRoots a = composed.solve(o, d, -1, 1), b = powers.solve(o, d, -1, 1);
      REQUIRE(a.roots.size() == b.roots.size());
      for (std::size_t i = 0; i < a.roots.size(); ++i) {
        CHECK(a.roots[i].lo == b.roots[i].lo);
        CHECK(a.roots[i].hi == b.roots[i].hi);
      }
    }
  }
}

TEST_CASE("numbers that are none are refused in one sentence") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Expression x = parse_expression("x");
  CHECK_THROWS_WITH(FormulaReference(x, nan), Catch::Contains("the iso-value of the reference is nan"));
  CHECK_THROWS_WITH(FormulaReference(x, 0, INFINITY), Catch::Contains("the time"));
  const FormulaReference f(x);
  CHECK_THROWS_WITH(f.solve({0, nan, 0}, {1, 0, 0}, 0, 1), Catch::Contains("the origin"));
  CHECK_THROWS_WITH(f.solve({0, 0, 0}, {1, 0, INFINITY}, 0, 1), Catch::Contains("the direction"));
  CHECK_THROWS_WITH(f.solve({0, 0, 0}, {1, 0, 0}, 1, 1), Catch::Contains("1 to 1"));
  // numbers of very different sizes
  check_roots(f.solve({-1e-300, 1e300, 0}, {1e-300, 0, 0}, 0, 4), {{1}});
}
