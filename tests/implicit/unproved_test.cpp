// Methods that prove nothing: they find what the others find.
#include <implicit/formula_surfaces.h>

#include <catch2/catch.hpp>

using namespace isocast;
using namespace isocast::test;

TEST_CASE("inclusions that round to the nearest find the same crossings, and prove nothing") {
  std::mt19937_64 random(7);
  for (const Choice& method : kNearest)
    for (const bool precise : {false, true}) {
      INFO(method.method << (precise ? " double" : " float"));
      const char* formula = "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8";
      const ImplicitSurface surface = surface_of(formula, options_of(method, precise)),
                            outward = surface_of(formula,
                                                 options_of({method.method, "rounding", "outward"}, precise));
      CHECK_FALSE(surface.proves());
      int differ = 0, hits_seen = 0;
      for (int round = 0; round < 8; ++round) {
        const auto s = random_streams(random);
        const HitStream hits = first_hits(surface, s->rays), proved = first_hits(outward, s->rays);
        for (int i = 0; i < s->rays.size; ++i) {
          if (!std::isinf(hits.t[i])) CHECK(hits.certificate[i] == Certificate::no_proof);
          hits_seen += !std::isinf(hits.t[i]);
          const double d = length({s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]});
          const bool same =
              std::isinf(hits.t[i]) ? std::isinf(proved.t[i]) : std::abs(hits.t[i] - proved.t[i]) * d < 0.01;
          differ += !same;
        }
      }
      CHECK(hits_seen > 300);
      // a grazing ray or two
      CHECK(differ <= 2);
    }
}

TEST_CASE("marching points find the sphere's crossings, prove nothing, and touch only where they may") {
  std::mt19937_64 random(6);
  for (const Choice& method : kMarching) {
    INFO(method.method);
    const ImplicitSurface surface = surface_of("x^2 + y^2 + z^2 - 1.44", options_of(method, true));
    CHECK_FALSE(surface.proves());
    int hits_seen = 0;
    for (int round = 0; round < 8; ++round) {
      const auto s = random_streams(random);
      HitStream hits = first_hits(surface, s->rays);
      for (int i = 0; i < s->rays.size; ++i) {
        bool close = false;
        const auto roots = sphere_roots(s->rays, i, 1.2L, close);
        // two roots within a step, or a near miss of one, are what the methods may get wrong
        const double d = length({s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]});
        if (roots.size() == 2 && (roots[1] - roots[0]) * d < 0.1) continue;
        if (roots.empty()) continue;
        REQUIRE(hits.t[i] == Approx(static_cast<double>(roots[0])).epsilon(1e-6));
        CHECK(hits.certificate[i] == Certificate::no_proof);
        ++hits_seen;
      }
      TraceCounts counts;
      surface.next_hit(s->rays, hits, counts);
      for (int i = 0; i < s->rays.size; ++i) {
        bool close = false;
        const auto roots = sphere_roots(s->rays, i, 1.2L, close);
        const double d = length({s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]});
        if (roots.size() != 2 || (roots[1] - roots[0]) * d < 0.1) continue;
        const double exit = static_cast<double>(roots[1]);
        REQUIRE(hits.t[i] == Approx(exit).epsilon(1e-6));
      }
    }
    CHECK(hits_seen > 300);
  }
  const auto look = [](const Choice& method, const char* formula, double offset) {
    ImplicitSurfaceOptions options = options_of(method);
    options.method.offset = offset;
    auto s = make_streams();
    add_ray(s->rays, {-1.9, 0.3, 0.4}, {1, 0, 0});
    return first_hits(surface_of(formula, options), s->rays).t[0];
  };
  // the sign test misses what only touches zero, unless the surface is fattened; Taylor's finds it
  CHECK(std::isinf(look(kMarching[0], "(x - 0.123)^2", 0)));
  CHECK(look(kMarching[0], "(x - 0.123)^2", 0.01) == Approx(1.923).epsilon(1e-3));
  CHECK(look(kMarching[1], "(x - 0.123)^2", 0) == Approx(2.023).epsilon(1e-2));
}
