// Every surface of the catalogue, and closed forms for some.
#include <isocast/implicit/expression/catalogue.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

using Form = std::function<double(double x, double y, double z, double w)>;

double sq(double a) { return a * a; }
const double kPhi = (1 + std::sqrt(5.0)) / 2;

// Chebyshev polynomials by their recurrence.
double chebyshev(int n, double x) {
  double a = 1, b = x;
  for (int i = 1; i < n; ++i) a = std::exchange(b, 2 * x * b - a);
  return b;
}
Form chmutov(int n, double constant) {
  return [=](double x, double y, double z, double) {
    return chebyshev(n, x) + chebyshev(n, y) + chebyshev(n, z) + constant;
  };
}

const std::map<std::string, Form> kForms = {
    {"sphere", [](double x, double y, double z, double) { return x * x + y * y + z * z - 1; }},
    {"ding_dong", [](double x, double y, double z, double) { return x * x + y * y - (1 - z) * z * z; }},
    {"kiss",
     [](double x, double y, double z, double) { return x * x + y * y - std::pow(z, 4) + std::pow(z, 5); }},
    {"cayley",
     [](double x, double y, double z, double) { return 4 * (x * x + y * y + z * z) - 16 * x * y * z - 1; }},
    {"tangle",
     [](double x, double y, double z, double) {
       const auto g = [](double t) { return t * t * t * t - 5 * t * t; };
       return g(x) + g(y) + g(z) + 11.8;
     }},
    {"mitchell",
     [](double x, double y, double z, double) {
       const double s = y * y + z * z;
       return 4 * (std::pow(x, 4) + s * s) + 17 * x * x * s - 20 * (x * x + s) + 17;
     }},
    {"torus",
     [](double x, double y, double z, double) {
       return (sq(std::hypot(x, y) - 1) + z * z - 0.16) * (sq(std::hypot(x, y) + 1) + z * z - 0.16);
     }},
    {"torus_sqrt",
     [](double x, double y, double z, double) { return sq(1 - std::hypot(x, y)) + z * z - 0.16; }},
    {"goursat", [](double x, double y, double z,
                   double) { return std::pow(x, 4) + std::pow(y, 4) + std::pow(z, 4) - 1; }},
    {"piriform", [](double x, double y, double z, double) { return x * x * x * (x - 1) + y * y + z * z; }},
    {"barth_sextic",
     [](double x, double y, double z, double) {
       const double p = kPhi * kPhi, a = x * x, b = y * y, c = z * z;
       return 4 * (p * a - b) * (p * b - c) * (p * c - a) - (1 + 2 * kPhi) * sq(a + b + c - 1);
     }},
    {"hunt",
     [](double x, double y, double z, double) {
       const double a = x * x + y * y + z * z - 13, b = 3 * x * x + y * y - 4 * z * z - 12;
       return 4 * a * a * a + 27 * b * b;
     }},
    {"high_silhouette",
     [](double x, double y, double, double) { return sq(y - x * x * x) - std::pow(y, 5); }},
    {"nonisol", [](double x, double y, double, double) { return sq(y - std::pow(x, 4)) - std::pow(y, 8); }},
    {"chmutov_6", chmutov(6, 0)},
    {"chmutov_9", chmutov(9, 1)},
    {"chmutov_14", chmutov(14, 0)},
    {"chmutov_14_power", chmutov(14, 0)},
    {"chmutov_50", chmutov(50, 0)},
    {"scherk", [](double x, double y, double z, double) { return std::exp(z) * std::cos(y) - std::cos(x); }},
    {"superquadric", [](double x, double y, double z,
                        double) { return std::pow(x, 4) + std::pow(y, 4) + std::pow(z, 4) - 1; }},
    {"cloth",
     [](double x, double y, double z, double w) {
       return y - 0.5 * std::sin(x + 3 * w) - 0.1 * (1 + 0.1 * std::sin(x * z)) * std::cos(z + 3 * w);
     }},
    {"trilinear_cell",
     [](double x, double y, double z, double) { return (1 - 2 * x) * (1 - 2 * y) * (1 - 2 * z) / 2; }},
};

// Points of a domain with some time, the same in each run.
class Points {
 public:
  explicit Points(const CatalogueSurface& surface) : surface_(surface) {}
  std::array<double, 4> next() {
    std::array<double, 4> p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] =
          surface_.domain.lo[axis] + unit_(random_) * (surface_.domain.hi[axis] - surface_.domain.lo[axis]);
    p[3] = surface_.kind == "dynamic" ? unit_(random_) : 0;
    return p;
  }

 private:
  const CatalogueSurface& surface_;
  std::mt19937_64 random_{5};
  std::uniform_real_distribution<double> unit_{0, 1};
};

}  // namespace

TEST_CASE("the catalogue has 80 surfaces, each with its own id") {
  std::set<std::string> ids;
  for (const CatalogueSurface& surface : catalogue()) {
    ids.insert(surface.id);
    CHECK(find_surface(surface.id) == &surface);
    CHECK((surface.kind == "algebraic") == surface.degree.has_value());
  }
  CHECK(catalogue().size() == 80);
  CHECK(ids.size() == 80);
  CHECK(find_surface("nothing") == nullptr);
}

TEST_CASE("every surface parses, is finite in its domain and changes sign there") {
  for (const CatalogueSurface& surface : catalogue()) {
    INFO(surface.id);
    const Tape tape = make_tape(simplify(surface_expression(surface)));
    CHECK(tape.registers <= 40);
    Points points(surface);
    int negative = 0, positive = 0;
    for (int i = 0; i < 20000 && (i < 1000 || negative == 0 || positive == 0); ++i) {
      const std::array<double, 4> at = points.next();
      const double f = run(tape, at);
      REQUIRE(std::isfinite(f));
      REQUIRE(std::isfinite(run<float>(tape, {float(at[0]), float(at[1]), float(at[2]), float(at[3])})));
      (f < 0 ? negative : positive) += 1;
    }
    CHECK(negative > 0);
    CHECK(positive > 0);
  }
}

TEST_CASE("formulas agree with closed forms, simplified or not") {
  for (const auto& [id, form] : kForms) {
    INFO(id);
    const CatalogueSurface& surface = require_surface(id);
    const Expression plain = surface_expression(surface);
    const Tape tape = make_tape(simplify(plain)), plain_tape = make_tape(plain);
    Points points(surface);
    for (int i = 0; i < 1000; ++i) {
      const std::array<double, 4> at = points.next();
      const double expected = form(at[0], at[1], at[2], at[3]);
      const double margin = id == "chmutov_14_power" ? 1e-8 : 1e-10;
      REQUIRE(run(tape, at) == Approx(expected).epsilon(1e-10).margin(margin));
      REQUIRE(run(plain_tape, at) == Approx(expected).epsilon(1e-10).margin(margin));
    }
  }
}

TEST_CASE("known points lie on their surfaces") {
  const auto at = [](const char* id, std::array<double, 4> p) {
    return run(make_tape(simplify(surface_expression(require_surface(id)))), p);
  };
  CHECK(at("sphere", {0.6, 0.8, 0}) == Approx(0).margin(1e-15));
  CHECK(at("cayley", {0.5, 0.5, 0.5}) == 0);
  CHECK(at("cayley", {0.5, -0.5, -0.5}) == 0);
  CHECK(at("kummer", {1, -1, 0}) == 0);
  CHECK(at("steiner", {0.2, 0, 0}) == 0);
  CHECK(at("blinn_blobby_75", {std::sqrt(75 * 0.08 - 0.01), 0, 0, 0}) == Approx(0).margin(1e-12));
  CHECK(at("super_sphere_16", {std::pow(0.0001, 1.0 / 16), 0, 0}) == Approx(0).margin(1e-15));
}

TEST_CASE("parameters are kept as written and can be overridden") {
  const CatalogueSurface& tangle = require_surface("tangle");
  REQUIRE(tangle.params.size() == 1);
  CHECK(tangle.params[0].value.text == "118e-1");
  const Tape tape = make_tape(surface_expression(tangle, {{"c", decimal_constant("7").value()}}));
  CHECK(run(tape, {}) == 7);
  CHECK(require_surface("barth_sextic").params[0].value.text == "1618033988749895e-15");
}

TEST_CASE("wrong ids and parameters are named") {
  CHECK_THROWS_WITH(require_surface("tangel"),
                    "found no surface 'tangel' in the catalogue, expected one that 'isocast surfaces' "
                    "lists; the nearest is 'tangle'");
  CHECK_THROWS_WITH(surface_expression(require_surface("torus"), {{"q", exact_constant(1)}}),
                    "found the parameter 'q', expected one of R r of @torus");
  CHECK_THROWS_WITH(surface_expression(require_surface("kiss"), {{"q", exact_constant(1)}}),
                    "found the parameter 'q', expected none of @kiss");
}
