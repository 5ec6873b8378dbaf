// The terms of polynomials: exact, with what cancels gone, and equal to the formula wherever it is evaluated.
#include <isocast/apps/reference/polynomial_terms.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace isocast;
using reference::polynomial_terms, reference::PolynomialTerms;

namespace {

PolynomialTerms terms_of(const char* formula) { return polynomial_terms(parse_expression(formula), 0.5); }
std::string coefficient(const PolynomialTerms& terms, int i, int j, int k) {
  for (const auto& term : terms.terms)
    if (term.i == i && term.j == j && term.k == k) return term.coefficient;
  return "none";
}

}  // namespace

TEST_CASE("coefficients are exact, and what cancels does not count") {
  const PolynomialTerms cube = terms_of("(x + y)^3 - x^3 - 0.1*z + w");
  CHECK(cube.reason.empty());
  CHECK(cube.rational);
  CHECK(cube.degree == 3);
  CHECK(coefficient(cube, 3, 0, 0) == "none");
  CHECK(coefficient(cube, 2, 1, 0) == "3");
  CHECK(coefficient(cube, 0, 0, 1) == "-1/10");
  CHECK(coefficient(cube, 0, 0, 0) == "1/2");
  CHECK(terms_of("(x+y)^4 - (x-y)^4 - 8*x^3*y - 8*x*y^3").terms.empty());
  CHECK(terms_of("x^4 - (x^2-1)*(x^2+1) + y").degree == 1);
  // phi^2 is phi + 1, and sqrt(2)^2 is 2
  CHECK(terms_of("(phi^2 - phi)*x^2 + y").rational);
  CHECK(coefficient(terms_of("sqrt(2)*x*sqrt(2)*y + z"), 1, 1, 0) == "2");
}

TEST_CASE("irrational coefficients are balls") {
  const PolynomialTerms terms = terms_of("x*pi^2/sqrt(3) + exp(1)*y - cos(w)*z");
  CHECK_FALSE(terms.rational);
  REQUIRE(terms.terms.size() == 3);
  CHECK(terms.terms[0].lo <= 9.869604401089358 / 1.7320508075688772 + 1e-14);
  CHECK(terms.terms[0].hi >= 9.869604401089358 / 1.7320508075688772 - 1e-14);
  CHECK(terms.terms[0].hi - terms.terms[0].lo < 1e-14);
  CHECK(terms.terms[1].lo == Approx(2.718281828459045));
  CHECK(terms.terms[2].lo == Approx(-0.8775825618903728));
}

TEST_CASE("what is no polynomial says why") {
  CHECK(terms_of("x + sin(y)").reason == "not a polynomial because of sin");
  CHECK(terms_of("1/x").reason == "not a polynomial because of a division by what depends on x, y or z");
  CHECK(terms_of("x^2.5").reason == "not a polynomial because of a power that is no whole number");
  CHECK(terms_of("max(x, y)").reason == "not a polynomial because of max");
  CHECK_FALSE(terms_of("x^61").reason.empty());
  CHECK_FALSE(terms_of("(x+y+z+1)^60*(x+y+z+1)").reason.empty());
}

TEST_CASE("the terms of the catalogue's polynomials are the formulas") {
  std::mt19937_64 random(1);
  int polynomials = 0;
  for (const CatalogueSurface& surface : catalogue()) {
    const Expression expression = surface_expression(surface);
    const auto bound = polynomial_degree(expression).degree;
    // cancellation leaves no digits of a sum of powers that high
    if (!bound || *bound > 16) continue;
    INFO(surface.id);
    const PolynomialTerms terms = polynomial_terms(expression, 0.3);
    REQUIRE(terms.reason.empty());
    ++polynomials;
    CHECK(terms.degree <= *bound);
    if (surface.degree) CHECK(terms.degree == *surface.degree);
    const Tape tape = make_tape(simplify(expression));
    std::vector<double> registers(tape.registers);
    for (int n = 0; n < 20; ++n) {
      double p[4] = {0, 0, 0, 0.3};
      for (int a = 0; a < 3; ++a)
        p[a] = std::uniform_real_distribution<double>(surface.domain.lo[a], surface.domain.hi[a])(random);
      long double sum = 0, size = 0;
      for (const auto& t : terms.terms) {
        const long double term =
            static_cast<long double>(0.5 * (t.lo + t.hi)) * std::pow(static_cast<long double>(p[0]), t.i) *
            std::pow(static_cast<long double>(p[1]), t.j) * std::pow(static_cast<long double>(p[2]), t.k);
        sum += term, size += std::abs(term);
      }
      const double f = evaluate(tape.view(), static_cast<const double*>(p), registers.data());
      CHECK(std::abs(static_cast<double>(sum) - f) <= 1e-12 * static_cast<double>(size) + 1e-12);
    }
  }
  CHECK(polynomials > 40);
}
