#include <fmt/format.h>
#include <isocast/apps/bench/stress_case.h>
#include <isocast/apps/bench/stress_texts.h>
#include <isocast/implicit/expression/catalogue.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isocast::bench {
namespace {

// text  a formula, or @id with the domain of the catalogue
struct StressFormula {
  const char* name;
  std::string text;
  const char* stresses;
  std::vector<Expectation> expected = {};
  double half_width = 1;
  MakeRays rays = framing_rays;
  std::vector<double> iso = {0};
  Double3 center = {0, 0, 0};
};

using enum Counted;
const Expectation kNoProvedHit = {proved_hit, 0, 0}, kNoProvedMiss = {proved_miss, 0, 0},
                  kAllUndecided = {undecided, 100, 100, kProving}, kDecided = {undecided, 0, 2, kProving},
                  kDecidedInDouble = {undecided, 0, 2, kProving, "double"};

const std::vector<StressFormula>& formulas() {
  static const std::vector<StressFormula> all = {
      {"sphere", "x^2+y^2+z^2-0.5", "nothing: what others are compared with", {{wrong, 0, 0}, kDecided}},
      {"chebyshev_50_powers",
       chebyshev_powers("x") + "+" + chebyshev_powers("y") + "+" + chebyshev_powers("z") + "-3",
       "T50 as powers: coefficients of 1e18 cancel near the ends",
       {{wrong, 20, 100, "amp-taylor"}, {undecided, 90, 100, kProving}}},
      {"chebyshev_50_recurrence",
       "chebyshev(50,x)+chebyshev(50,y)+chebyshev(50,z)",
       "the same formula by its recurrence",
       {{wrong, 0, 10, "amp-taylor"}, kDecided}},
      {"chebyshev_50_composed",
       "@chmutov_50",
       "T50 as T2 of T5 of T5",
       {{wrong, 0, 10, "amp-taylor"}, kDecided}},
      {"steep_walls", "x^500+y^500+z^500-1", "powers that underflow and overflow", {kDecided}, 1.2},
      {"steiner_whiskers",
       "@steiner",
       "double lines, on which f touches zero",
       {kAllUndecided, {wrong, 0, 0, "amp-sign"}},
       1,
       across_steiner},
      {"cross_cap_whiskers",
       "@cross_cap",
       "double lines, on which f touches zero",
       {kAllUndecided, {wrong, 0, 0, "amp-sign"}},
       1,
       across_cross_cap},
      {"teardrop_tip",
       "@teardrop",
       "a tip with a radius of 7e-7 to 7e-5",
       {kNoProvedMiss, kDecidedInDouble, {wrong, 90, 100, "amp-sign"}},
       1,
       across_teardrop_tip},
      {"squared_sphere",
       "(x^2+y^2+z^2-0.25)^2",
       "f touches zero all over the surface",
       {kNoProvedHit, {wrong, 0, 0, "amp-sign"}}},
      {"squared_sphere_on",
       "(x^2+y^2+z^2-0.31640625)^2",
       "the same, from points on it",
       {kAllUndecided},
       1,
       rays_from_sphere},
      {"step_tanh",
       "tanh(1e4*x)",
       "a step of a ten thousandth that is continuous",
       {{wrong, 0, 0}, kDecided}},
      {"shell_tanh",
       "tanh(1e4*(x^2+y^2+z^2-0.5))+0.999",
       "f is constant but in a thin shell",
       {{wrong, 0, 0}, kDecided}},
      {"oscillation", "sin(1/x)", "infinitely many roots before x = 0", {kDecided}},
      {"damped_oscillation", "x*sin(1/x)-y/4", "roots that accumulate", {kDecided}},
      {"pole", "1/x", "a change of sign that is no root", {kNoProvedHit}},
      {"pole_shifted", "1/(x-0.1)", "the same where binary numbers do not meet it", {kNoProvedHit}},
      {"poles_sin", "1/sin(9*x)", "many poles", {kNoProvedHit}},
      {"poles_tan", "tan(9*x)-y", "poles between roots"},
      {"floor_steps", "floor(4*x)+0.5", "jumps across zero", {kNoProvedHit}},
      {"sign_jump", "sign(x-y)", "a jump along a plane", {kNoProvedHit}},
      {"floor_sheet", "x-floor(8*y)/8-round(z)", "roots between jumps", {{undecided, 0, 10, kProving}}},
      {"sqrt_edge", "sqrt(0.5-x^2-y^2)-abs(z)", "a surface up to the edge of what is defined", {kDecided}},
      {"sqrt_touch", "sqrt(x)", "a root at the edge of what is defined", {kNoProvedHit}},
      {"log_edge", "log(x)+1+y", "minus infinity at the edge of what is defined", {kDecidedInDouble}},
      {"xlogx", "x*log(abs(x))+y/8", "undefined at x = 0, where the limit is a number", {kDecided}},
      {"undefined", "sqrt(-1-x^2)", "nothing is defined", {{wrong, 0, 0}, kNoProvedHit, kDecided}},
      {"zero_over_zero", "0*x/(y-y)", "nothing is a number", {{wrong, 0, 0}, kNoProvedHit}},
      {"zero", "0*x", "f is zero everywhere", {kNoProvedHit, kNoProvedMiss}, 1, inner_rays},
      {"blob_steep", "exp(-1e6*(x^2+y^2+z^2-0.04))-1", "a blob with a = 1e6", {{wrong, 0, 0}, kDecided}},
      {"blobs_steep",
       "exp(-1e6*((x-0.2)^2+y^2+z^2-0.04))+exp(-1e6*((x+0.2)^2+y^2+z^2-0.04))-1",
       "two blobs with a = 1e6 that touch",
       {{wrong, 0, 0}, kDecided}},
      {"domain_1e-6", "x^2+y^2+z^2-1e-13", "a box 1e-6 wide", {{wrong, 0, 0}, kDecided}, 5e-7},
      {"domain_1e6", "x^2+y^2+z^2-1e11", "a box 1e6 wide", {{wrong, 0, 0}, kDecided}, 5e5},
      {.name = "domain_far",
       .text = "(x-1000000)^2+(y+1000000)^2+(z-1000000.5)^2-1",
       .stresses = "a box 1e6 away from the origin",
       .expected = {{wrong, 0, 5}, kDecidedInDouble},
       .half_width = 2,
       .center = {1e6, -1e6, 1e6}},
      {"values_1e-30", "1e-30*(x^2+y^2+z^2-0.5)", "values about 1e-30", {{wrong, 0, 0}, kDecided}},
      {"values_1e30", "1e30*(x^2+y^2+z^2-0.5)", "values about 1e30", {{wrong, 0, 0}, kDecided}},
      {"values_1e300",
       "1e300*(x^2+y^2+z^2-0.5)",
       "values that single precision does not have",
       {{wrong, 0, 0}, kDecidedInDouble}},
      {.name = "one_ulp",
       .text = "x^2+y^2+z^2",
       .stresses = "iso-values that are neighbours in double precision",
       .expected = {{undecided, 10, 100, kProving}, {wrong, 0, 5}},
       .iso = {0.5, std::nextafter(0.5, 1)}},
      {"wilkinson_factors",
       wilkinson_factors(20),
       "twenty roots in a row, as a product",
       {{wrong, 0, 0}, kDecided},
       1.05,
       lengthwise_rays},
      {"wilkinson_powers",
       wilkinson_powers(18),
       "eighteen roots in a row, as powers: coefficients cancel",
       {{wrong, 5, 100, "amp-sign", "float"}, {undecided, 50, 100, kProving, "float"}},
       1.05,
       lengthwise_rays},
      {"tangent_spheres",
       "((x-0.5)^2+y^2+z^2-0.25)*((x+0.5)^2+y^2+z^2-0.25)",
       "a product of spheres that touch in one point",
       {{undecided, 0, 15, kProving}},
       1,
       axis_rays},
      {"nodes_65", "@barth_sextic", "65 ordinary double points", {{wrong, 0, 0}, kDecided}},
      {"nodes_99", "@labs_septic", "99 ordinary double points", {{wrong, 0, 0}, kDecided}},
      {"cusp", "y^2-x^3", "an edge where the gradient vanishes", {{wrong, 0, 0}, kDecided}},
      {"cusp_axes",
       "y^2-x^3+z^5",
       "rays along axes through a cusp",
       {{undecided, 0, 10, kProving}},
       1,
       axis_rays},
      {"thin_shell",
       "(x^2+y^2+z^2-0.49)^2-1e-12",
       "two sheets 1.4e-6 apart, much closer than pixels",
       {{wrong, 10, 100, "amp-sign"}, kDecidedInDouble}},
      {"sphere_axes",
       "x^2+y^2+z^2-0.25",
       "rays along axes, some of them tangent",
       {{wrong, 0, 0, kProving}, {undecided, 0, 10, kProving}},
       1,
       axis_rays},
      {"sphere_inside",
       "x^2+y^2+z^2-0.5",
       "rays that start inside the box",
       {{wrong, 0, 0}, kDecided},
       1,
       inner_rays},
      {"sphere_on",
       "x^2+y^2+z^2-0.31640625",
       "rays that start exactly on the surface",
       {{wrong, 0, 0, kProving}},
       1,
       rays_from_sphere},
  };
  return all;
}

FormulaSource source_of(const StressFormula& formula) {
  if (formula.text.starts_with('@')) {
    const CatalogueSurface& surface = require_surface(formula.text.substr(1));
    return {surface_expression(surface), surface.domain};
  }
  FormulaSource source{parse_expression(formula.text), {}};
  for (std::size_t a = 0; a < 3; ++a) {
    source.domain.lo[a] = formula.center[a] - formula.half_width;
    source.domain.hi[a] = formula.center[a] + formula.half_width;
  }
  return source;
}

}  // namespace

std::vector<StressCase> stress_formulas() {
  std::vector<StressCase> cases;
  for (const StressFormula& formula : formulas()) {
    StressCase& stress = cases.emplace_back(StressCase{
        std::string("formulas/") + formula.name, formula.stresses, {}, formula.rays, formula.expected});
    stress.scene.objects.front().source = source_of(formula);
    stress.scene.objects.front().iso = formula.iso;
  }
  return cases;
}

}  // namespace isocast::bench
