// Chebyshev polynomials: recognised however they are written, and computed in a stable form.
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/polynomial.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// The degree when the simplified formula is T_n of x, else 0.
int degree_of(std::string_view text) {
  const Expression simple = simplify(parse_expression(text));
  const Node& root = simple.node(simple.root());
  return root.op == Op::chebyshev && simple.node(root.a).op == Op::variable ? root.n : 0;
}

int chebyshev_count(const CatalogueSurface& surface) {
  int count = 0;
  for (const Instruction& i : make_tape(simplify(surface_expression(surface))).code)
    count += i.op == Op::chebyshev;
  return count;
}

}  // namespace

TEST_CASE("the coefficients are those of the tables") {
  using Coefficients = std::vector<std::int64_t>;
  CHECK(chebyshev_coefficients(0) == Coefficients{1});
  CHECK(chebyshev_coefficients(1) == Coefficients{0, 1});
  CHECK(chebyshev_coefficients(2) == Coefficients{-1, 0, 2});
  CHECK(chebyshev_coefficients(5) == Coefficients{0, 5, 0, -20, 0, 16});
  CHECK(chebyshev_coefficients(50).back() == 562949953421312);
}

TEST_CASE("Chebyshev polynomials are recognised") {
  CHECK(degree_of("4*x^3 - 3*x") == 3);
  CHECK(degree_of("x*(4*x^2 - 3)") == 3);
  CHECK(degree_of("-3*x + x*x*x*4") == 3);
  CHECK(degree_of("8*x^4 - 8*x^2 + 1") == 4);
  CHECK(degree_of("2*(2*x^2 - 1)^2 - 1") == 4);
  CHECK(degree_of("t2 = 2*x*x - 1; t3 = 2*x*t2 - x; t4 = 2*x*t3 - t2; 2*x*t4 - t3") == 5);
  CHECK(degree_of("t(a) = 4*a^3 - 3*a; t(t(t(x)))") == 27);
  CHECK(degree_of("2*chebyshev(40, x)*chebyshev(3, x) - chebyshev(37, x)") == 43);
  CHECK(degree_of("chebyshev(6, chebyshev(7, x))") == 42);
  CHECK(degree_of("chebyshev(32, chebyshev(32, x))") == 1024);
  const Expression of_sine = simplify(parse_expression("4*sin(x)^3 - 3*sin(x)"));
  CHECK(of_sine.node(of_sine.root()).op == Op::chebyshev);
}

TEST_CASE("what is no Chebyshev polynomial is left alone") {
  for (const char* text :
       {"2*x^2 - 1", "4*x^3 - 3*y", "4*x^3 - 3*x + 1", "4*x^3 - 2*x", "-(4*x^3 - 3*x)", "4*x^3 - 3.0000001*x",
        "cos(3*acos(x))", "chebyshev(33, chebyshev(32, x))", "x^1000 - 1", "1/(4*x^3 - 3*x)"})
    CHECK(degree_of(text) == 0);
  CHECK(degree_of("chebyshev(1, x)") == 0);
  CHECK(value("chebyshev(1, x)", {0.25}) == 0.25);
  CHECK(value("chebyshev(0, x)", {0.25}) == 1);
}

TEST_CASE("the Chmutov surfaces of the catalogue are recognised in both spellings") {
  int found = 0;
  for (const CatalogueSurface& surface : catalogue())
    if (surface.id.starts_with("chmutov")) {
      INFO(surface.id);
      CHECK(chebyshev_count(surface) == 3);
      ++found;
    }
  CHECK(found == 18);
}

TEMPLATE_TEST_CASE("high degrees lose little, near the ends too", "", float, double) {
  using T = TestType;
  const double u = sizeof(T) == 4 ? 0x1p-24 : 0x1p-53;
  std::mt19937_64 random(3);
  for (const int n : {1, 2, 3, 7, 14, 50, 200, 1000}) {
    const Tape tape = make_tape(simplify(parse_expression("chebyshev(" + std::to_string(n) + ", x)")));
    for (const double width : {1.0, 1e-2, 1e-5, 1e-12})
      for (int i = 0; i < 500; ++i) {
        const double distance = width * std::uniform_real_distribution<double>(-1, 1)(random);
        for (const double end : {-1.0, 1.0, 0.0}) {
          const T x = T(end + distance);
          long double before = 1, expected = x;  // in extended precision
          for (int k = 1; k < n; ++k) {
            const long double next = 2 * x * expected - before;
            before = std::exchange(expected, next);
          }
          if (!std::isfinite(T(expected))) continue;
          INFO(n << " " << x);
          REQUIRE(std::abs(double(run<T>(tape, {x}) - expected)) <=
                  2 * n * u * std::max(1.0, std::abs(double(expected))));
        }
      }
  }
}
