// What can break ray tracing of formulas: polynomials that cancel, whiskers, poles, jumps, stiff sums, tiny
// and far boxes. No proof is wrong, no hit is out of order, no ray takes for ever.
#include <fmt/format.h>
#include <implicit/stress_check.h>
#include <isocast/implicit/expression/polynomial.h>

#include "expression/evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// T_50 written as powers, but for its constant, with which it would be recognised.
std::string powers_of(const char* variable) {
  const std::vector<std::int64_t> c = chebyshev_coefficients(50);
  std::string text;
  for (std::size_t k = c.size(); k-- > 1;)
    if (c[k] != 0) text += fmt::format("{}{}*{}^{}", c[k] < 0 || text.empty() ? "" : "+", c[k], variable, k);
  return text;
}
double chebyshev_50(double x) {
  return std::abs(x) <= 1 ? std::cos(50 * std::acos(x)) : std::cosh(50 * std::acosh(std::abs(x)));
}

// Rays of amp-sign in float whose first hit is not the first root within the march's step.
int wrong_marches(const Formula& formula, const RayStream& rays, const Roots& roots) {
  const HitStream hits = trace(formula, "amp-sign", false, rays);
  int wrong = 0;
  for (int i = 0; i < rays.size; ++i) {
    const std::vector<reference::FormulaRoot>& found = roots[static_cast<std::size_t>(i)][0].roots;
    wrong += found.empty() ? hits.t[i] < 1 : !(std::abs(hits.t[i] - found[0].lo) < 1e-4);
  }
  return wrong;
}

}  // namespace

TEST_CASE("T_50: powers in float are noise near the ends, composition and recurrence are not") {
  const auto tape_of = [](const std::string& text) { return make_tape(parse_expression(text)); };
  const Tape by_powers = tape_of(powers_of("x") + "-1"), by_recurrence = tape_of("chebyshev(50, x)");
  const Tape composed =
      make_tape(of_catalogue("chmutov_50").expression);  // T_50 of x, y and z: -1 at y = z = 0
  double worst[3] = {};
  for (int k = 0; k <= 1000; ++k) {
    const float x = 0.9f + 0.0001f * float(k);
    const double truth = chebyshev_50(x);
    const auto value = [x](const Tape& tape) { return double(run<float>(tape, {x, 0, 0, 0})); };
    const double found[3] = {value(by_powers), value(by_recurrence), value(composed) + 2};
    for (int form = 0; form < 3; ++form) worst[form] = std::max(worst[form], std::abs(found[form] - truth));
  }
  CHECK(worst[0] > 1e6);
  CHECK(worst[1] < 2 * 50 * 0x1p-24);
  CHECK(worst[2] < 1e-3);
}

TEST_CASE("T_50: marching points in float goes wrong on powers only; proofs stay true, fewer of them") {
  const Formula powers = formula_of(powers_of("x") + "+" + powers_of("y") + "+" + powers_of("z") + "-3");
  const Formula recurrence = formula_of("chebyshev(50, x) + chebyshev(50, y) + chebyshev(50, z)");
  const auto s = chords(powers.domain, 24);
  const Roots roots = roots_of(recurrence, s->rays);  // the same numbers
  CHECK(wrong_marches(powers, s->rays, roots) > 20);
  CHECK(wrong_marches(recurrence, s->rays, roots) == 0);
  CHECK(wrong_marches(of_catalogue("chmutov_50"), s->rays, roots) == 0);
  const Tally by_powers = check(powers, s->rays, roots), by_recurrence = check(recurrence, s->rays, roots);
  CHECK(by_powers.undecided > 2 * by_recurrence.undecided);
}

TEST_CASE("x^500 and other steep walls") {
  CHECK(check(of_catalogue("superquadric_knoll")).hits > 50);
  CHECK(check("x^500 + y^500 + z^500 - 1", 1.2).hits > 50);
  CHECK(check("tanh(1e4*x)").hits > 50);
  CHECK(check("tanh(1e4*(x^2 + y^2 + z^2 - 0.5)) + 0.999").hits > 50);
}

TEST_CASE("whiskers and tips: a ray through them is never a proved miss") {
  const auto never_missed = [](const Formula& formula, const RayStream& rays) {
    const Tally tally = check(formula, rays);
    CHECK(tally.misses == 0);
    return tally;
  };
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> off(-0.4, 0.4), along(0.52, 0.58);
  auto steiner = make_streams(), cap = make_streams(), tip = make_streams();
  for (int n = 0; n < kRays; ++n) {
    // across a double line: f touches zero; the points are such that the ray meets the line exactly
    const double y = std::round(1024 * off(random)) / 1024, z = 0.25 + std::round(1024 * off(random)) / 4096;
    const double x = std::round(1024 * along(random)) / 1024;
    add_chord(steiner->rays, {x, -y, -z}, {x, y, z});
    add_chord(cap->rays, {-y, -z, -1.0625}, {y, z, -1.0625});
    // the teardrop's radius at x is x^2 sqrt((x + 1) / 2): 7e-7 to 7e-5
    const double at = -std::exp2(-7 - n / 16.0);
    add_chord(tip->rays, {at, -0.25, -0.125}, {at, 0.25, 0.125});
  }
  CHECK(never_missed(of_catalogue("steiner"), steiner->rays).hits == 0);
  CHECK(never_missed(of_catalogue("cross_cap"), cap->rays).hits == 0);
  never_missed(of_catalogue("teardrop"), tip->rays);
  check(of_catalogue("steiner"));
  check(of_catalogue("cross_cap"));
  check(of_catalogue("teardrop"));
}

TEST_CASE("what only touches zero is neither a proved hit nor, where it does, a proved miss") {
  const Formula touch = formula_of("(x^2 + y^2 + z^2 - 0.25)^2");
  auto s = make_streams();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  for (int n = 0; n < kRays; ++n)
    add_chord(s->rays, {-0.9, off(random), off(random)}, {0.9, off(random), off(random)});
  const Tally tally = check(touch, s->rays);
  CHECK(tally.hits == 0);
  CHECK(tally.misses == 0);
  CHECK(check(touch).hits == 0);
}

TEST_CASE("poles and jumps are no proved hits") {
  for (const char* text : {"1/x", "tan(2*x)*0 + 1/(x - 0.1)", "1/sin(9*x)", "sign(x)", "floor(4*x) + 0.5",
                           "round(3*x)/3 - 0.2", "step(0.1, x) - 0.5", "if(x > y, 1, -1)"}) {
    INFO(text);
    auto s = make_streams();
    for (int n = 0; n < 16; ++n)
      add_chord(s->rays, {-0.9, 0.05 * n - 0.4, 0.3}, {0.9, 0.05 * n - 0.45, -0.2});
    CHECK(check(formula_of(text), s->rays).hits == 0);
  }
  for (const char* text : {"sin(1/x)", "x*sin(1/x) - y/4", "tan(9*x) - y", "1/x - 3*y", "floor(4*x)/4 - y",
                           "mod(x, 0.25) - 0.1 + y/9", "x - floor(8*y)/8 - round(z)"})
    check(text);
}

TEST_CASE("edges of what is defined") {
  for (const char* text :
       {"sqrt(x) - 0.5 + y/4", "sqrt(x)", "sqrt(0.5 - x^2 - y^2) - abs(z)", "log(x) + 1 + y",
        "log(x)*x + 0.2", "x*log(abs(x)) + y/8", "acos(2*x) - 1 - y", "asin(x^2 + y^2) - z",
        "x^0.5 - y^1.5 + z", "sqrt(-1 - x^2)", "(x - 2)^0.5", "cbrt(x) + y^3"})
    check(text);
  CHECK(check("sqrt(-1 - x^2)").hits == 0);
}

TEST_CASE("stiff blobs") {
  CHECK(check("exp(-1e6*(x^2 + y^2 + z^2 - 0.04)) - 1").hits > 20);
  check("exp(-1e6*((x - 0.2)^2 + y^2 + z^2 - 0.04)) + exp(-1e6*((x + 0.2)^2 + y^2 + z^2 - 0.04)) - 1");
  check("1e6/(1e6*(x^2 + y^2 + z^2) + 1e-6) - 4");
  check(of_catalogue("blinn_blobby_75"));
}

TEST_CASE("tiny, huge and distant boxes") {
  CHECK(check("x^2 + y^2 + z^2 - 1e-13", 5e-7).hits > 50);
  CHECK(check("x^2 + y^2 + z^2 - 1e11", 5e5).hits > 50);
  CHECK(check("x^3 - 1e11*y + 1e5*z^2", 5e5).hits > 50);
  const Formula distant = {parse_expression("(x - 1000000)^2 + (y + 1000000)^2 + (z - 1000000.5)^2 - 1"),
                           {{999998, -1000002, 999998}, {1000002, -999998, 1000002}}};
  CHECK(check(distant).hits > 20);
  const Formula sheet = {parse_expression("sin(x) + y"), {{1e6, -2, -2}, {1e6 + 4, 2, 2}}};
  CHECK(check(sheet).hits > 50);
}

TEST_CASE("iso-values one ulp apart") {
  Formula formula = formula_of("x^2 + y^2 + z^2");
  for (const double iso : {0.5, 1e-3})
    for (const int ulps : {1, 3}) {
      formula.iso = {iso, iso};
      for (int n = 0; n < ulps; ++n) formula.iso[1] = std::nextafter(formula.iso[1], 1);
      check(formula);
      std::swap(formula.iso[0], formula.iso[1]);
      check(formula);
    }
  formula.iso.assign(kMostIsos, 0.25);
  for (std::size_t n = 1; n < kMostIsos; ++n) formula.iso[n] = std::nextafter(formula.iso[n - 1], 1);
  check(formula);
}
