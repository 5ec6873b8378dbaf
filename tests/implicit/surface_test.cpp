// ImplicitSurface: what it proves is true, the same bits on every instruction set, all crossings in order.
#include <fmt/format.h>
#include <implicit/formula_surfaces.h>
#include <isocast/base/error.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <limits>

using namespace isocast;
using namespace isocast::test;

namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("what is proved of a sphere is true, and little stays undecided", "[property]") {
  std::mt19937_64 random(1);
  for (const Choice& method : kProving)
    for (const bool precise : {false, true}) {
      INFO(method.method << " " << method.key << (precise ? " double" : " float"));
      const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1.44", options_of(method, precise));
      std::int64_t undecided = 0, hits_proved = 0, count = test::cases(8000, 250000);
      for (std::int64_t n = 0; n < count; n += kStreamSize) {
        const auto s = random_streams(random);
        const HitStream hits = first_hits(surface, s->rays);
        for (int i = 0; i < s->rays.size; ++i) {
          bool close = false;
          const auto roots = sphere_roots(s->rays, i, 1.2L, close);
          undecided += hits.certificate[i] == Certificate::undecided;
          if (close) continue;
          if (hits.certificate[i] == Certificate::proved_miss) REQUIRE(roots.empty());
          if (hits.certificate[i] != Certificate::proved_hit) continue;
          ++hits_proved;
          REQUIRE_FALSE(roots.empty());
          REQUIRE(hits.t_lo[i] <= roots[0]);
          REQUIRE(hits.t_hi[i] >= roots[0]);
          REQUIRE((hits.t_hi[i] - hits.t_lo[i]) * length({s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]}) <
                  0.01);
        }
      }
      CHECK(hits_proved > count / 10);
      CHECK(double(undecided) < (precise ? 1e-4 : 2e-3) * double(count));
    }
}

TEST_CASE("every instruction set gives the same bits, whatever the formula") {
  std::vector<Choice> all(std::begin(kProving), std::end(kProving));
  all.insert(all.end(), std::begin(kNearest), std::end(kNearest));
  all.insert(all.end(), std::begin(kMarching), std::end(kMarching));
  std::mt19937_64 random(2);
  for (const char* formula :
       {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "sin(3*x)*cos(2*y) - z/(x^2 + 0.1)",
        "min(abs(x) - 0.5, max(y, z^3 - exp(x)))", "if(x > y, sqrt(z) - 0.3, tan(z) + log(x + 2))"})
    for (const Choice& method : all)
      for (const bool precise : {false, true}) {
        INFO(formula << " " << method.method << " " << method.key);
        ImplicitSurfaceOptions options = options_of(method, precise, Isa::scalar);
        options.iso = {0, 0.25};
        ImplicitSurface surface = surface_of(formula, options);
        const auto s = random_streams(random);
        options.isa = Isa::scalar;
        surface.set_options(options);
        HitStream expected = first_hits(surface, s->rays), expected_next = expected;
        TraceCounts counts;
        surface.next_hit(s->rays, expected_next, counts);
        for (const Isa isa : available_isas()) {
          options.isa = isa;
          surface.set_options(options);
          HitStream hits = first_hits(surface, s->rays);
          const auto same = [&](const HitStream& a, const HitStream& b) {
            for (int i = 0; i < s->rays.size; ++i) {
              REQUIRE(a.t[i] == b.t[i]);
              REQUIRE(a.cost[i] == b.cost[i]);
              REQUIRE(a.certificate[i] == b.certificate[i]);
              if (std::isinf(a.t[i])) continue;
              REQUIRE(a.t_lo[i] == b.t_lo[i]);
              REQUIRE(a.t_hi[i] == b.t_hi[i]);
              REQUIRE(a.iso[i] == b.iso[i]);
              REQUIRE(a.sides[i] == b.sides[i]);
            }
          };
          same(expected, hits);
          surface.next_hit(s->rays, hits, counts);
          same(expected_next, hits);
        }
      }
}

TEST_CASE("next_hit gives both crossings of nested spheres, in order, once") {
  std::mt19937_64 random(3);
  for (const Choice& method : kProving) {
    ImplicitSurfaceOptions options = options_of(method, true);
    options.iso = {1, 0.25};
    const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2", options);
    std::int64_t crossings = 0;
    for (int round = 0; round < 4; ++round) {
      const auto s = random_streams(random);
      HitStream hits = first_hits(surface, s->rays);
      TraceCounts counts;
      std::vector<std::vector<std::pair<double, int>>> found(static_cast<std::size_t>(s->rays.size));
      for (int step = 0; step < 6; ++step) {
        for (int i = 0; i < s->rays.size; ++i)
          if (hits.t[i] < kInfinity) found[static_cast<std::size_t>(i)].push_back({hits.t[i], hits.iso[i]});
        surface.next_hit(s->rays, hits, counts);
      }
      for (int i = 0; i < s->rays.size; ++i) {
        bool close = false, closer = false;
        std::vector<std::pair<long double, int>> expected;
        for (const long double t : sphere_roots(s->rays, i, 1, close)) expected.push_back({t, 0});
        for (const long double t : sphere_roots(s->rays, i, 0.5L, closer)) expected.push_back({t, 1});
        if (close || closer) continue;
        std::ranges::sort(expected);
        const auto& mine = found[static_cast<std::size_t>(i)];
        INFO(method.method << " " << method.key << " round " << round << " ray " << i);
        REQUIRE(mine.size() == expected.size());
        for (std::size_t k = 0; k < mine.size(); ++k) {
          REQUIRE(mine[k].first == Approx(static_cast<double>(expected[k].first)).epsilon(1e-9));
          REQUIRE(mine[k].second == expected[k].second);
          ++crossings;
        }
      }
    }
    CHECK(crossings > 400);
  }
}

TEST_CASE("a ray that starts on the surface does not hit its start, but what lies behind") {
  const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1", options_of(kProving[2]));
  auto s = make_streams();
  add_ray(s->rays, {-1, 0, 0}, {1, 0, 0});   // inwards: the far side
  add_ray(s->rays, {-1, 0, 0}, {-1, 0, 0});  // outwards: nothing
  s->rays.start_object[0] = s->rays.start_object[1] = 0;
  s->rays.start_sides[0] = 1;
  const HitStream hits = first_hits(surface, s->rays);
  CHECK(hits.t[0] == Approx(2).epsilon(1e-6));
  CHECK(hits.sides[0] == 1);
  CHECK(std::isinf(hits.t[1]));
}

TEST_CASE("neither a pole nor a jump is a proved hit, nor a touch a proved miss") {
  const auto look = [](const std::string& formula, bool precise) {
    const ImplicitSurface surface = surface_of(formula, options_of(kProving[2], precise));
    auto s = make_streams();
    add_ray(s->rays, {-1.9, 0.3, 0.4}, {1, 0, 0});
    return first_hits(surface, s->rays);
  };
  for (const bool precise : {false, true}) {
    for (const char* jump :
         {"1/(x - 0.3)", "tan(x)*0 + 1/x", "floor(x) + 0.5", "sign(x) + 0*x", "if(x > 0.1, 1, -1)"}) {
      INFO(jump);
      CHECK(look(jump, precise).certificate[0] != Certificate::proved_hit);
    }
    for (const char* touch : {"(x - 0.123)^2", "abs(x - 0.123)", "(x^2 - 0.5)^2", "sqrt(x - 0.1)"}) {
      INFO(touch);
      CHECK(look(touch, precise).certificate[0] == Certificate::undecided);
    }
    const HitStream root = look("x^3 - 0.2", precise);
    CHECK(root.certificate[0] == Certificate::proved_hit);
    CHECK(root.t[0] == Approx(1.9 + std::cbrt(0.2)).epsilon(1e-5));
    CHECK(look("x^2 + 0.001", precise).certificate[0] == Certificate::proved_miss);
  }
}

TEST_CASE("values and normals at hits are those of the formula") {
  const ImplicitSurface surface = surface_of("x^2 + 2*y^2 + 3*z^2 - 1", options_of(kProving[2], true));
  std::mt19937_64 random(5);
  const auto s = random_streams(random);
  const HitStream hits = first_hits(surface, s->rays);
  const auto dressed = std::make_unique<DressedHits>();
  surface.dress(s->rays, hits, {true, true, true}, *dressed);
  int seen = 0;
  for (int i = 0; i < s->rays.size; ++i) {
    if (std::isinf(hits.t[i])) continue;
    ++seen;
    const Double3 p = {dressed->position[0][i], dressed->position[1][i], dressed->position[2][i]};
    const Double3 n = normalized({p[0], 2 * p[1], 3 * p[2]});
    const double turn = n[0] * s->rays.dx[i] + n[1] * s->rays.dy[i] + n[2] * s->rays.dz[i] > 0 ? -1 : 1;
    for (std::size_t a = 0; a < 3; ++a) CHECK(dressed->normal[a][i] == Approx(turn * n[a]).margin(1e-9));
    CHECK(dressed->value[i] == Approx(0).margin(1e-9));
  }
  CHECK(seen > 20);
}

TEST_CASE("hits know the component of a solid, and difference normals come near the gradient's") {
  ImplicitSurfaceOptions options = options_of(kProving[2], true);
  options.components = true;
  options.normals = NormalKind::difference;
  const ImplicitSurface surface =
      surface_of("max(min((x - 1)^2 + y^2 + z^2 - 0.5, (x + 1)^2 + y^2 + z^2 - 0.5), -(z - 0.1))", options);
  CHECK(surface.component_count() == 3);
  auto s = make_streams();
  add_ray(s->rays, {1, 0, 3}, {0, 0, -1});
  add_ray(s->rays, {-1, 0, 3}, {0, 0, -1});
  add_ray(s->rays, {1, 0, -3}, {0, 0, 1});
  const HitStream hits = first_hits(surface, s->rays);
  const auto dressed = std::make_unique<DressedHits>();
  surface.dress(s->rays, hits, {true, false, false}, *dressed);
  for (int i = 0; i < 3; ++i) {
    CHECK(hits.cell[0][i] == i);
    CHECK(dressed->normal[2][i] == Approx(i == 2 ? -1 : 1));
    CHECK(dressed->normal[0][i] == Approx(0).margin(1e-6));
  }
  // a few lines whose tree has 2^60 leaves
  std::string shared = "let a0 = min(x, y);";
  for (int i = 1; i < 60; ++i) shared += fmt::format("let a{} = min(a{}, max(-a{}, z));", i, i - 1, i - 1);
  CHECK(surface_of(shared + "a59", options).component_count() <=
        Components::kMostParts + Components::kDeepest);
}

TEST_CASE("formulas and options that cannot be used are refused in one sentence") {
  ImplicitSurfaceOptions options;
  options.iso.assign(17, 0);
  CHECK_THROWS_WITH(surface_of("x", options), Catch::Contains("1 to 16"));
  options.iso = {kInfinity};
  CHECK_THROWS_WITH(surface_of("x", options), Catch::Contains("no finite number"));
  CHECK_THROWS_WITH(ImplicitSurface(parse_expression("x"), Domain{{0, 0, 0}, {1, 0, 1}}, {}),
                    Catch::Contains("axis y goes from 0 to 0"));
  CHECK_THROWS_WITH(choose_formula_method("newton", {}), Catch::Contains("interval, affine"));
  CHECK_THROWS_WITH(choose_formula_method("interval", {{"trim", "1"}}),
                    Catch::Contains("it has: eps, eps-rel"));
  CHECK_THROWS_WITH(choose_formula_method("affine", {{"bisection", "x"}}), Catch::Contains("one of: t, k"));
}
