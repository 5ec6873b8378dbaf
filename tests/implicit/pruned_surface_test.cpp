// Surfaces whose tapes are pruned where rays run and hit, against the same with whole tapes.
#include <fmt/format.h>
#include <implicit/formula_surfaces.h>
#include <isocast/render/camera.h>

#include <catch2/catch.hpp>

using namespace isocast;
using namespace isocast::test;

namespace {

std::string union_of_balls(std::mt19937_64& random) {
  std::string balls;
  std::uniform_real_distribution<double> place(-1.8, 1.8);
  for (int i = 0; i < 40; ++i)
    balls = fmt::format("{}(x - {:.3f})^2 + (y - {:.3f})^2 + (z - {:.3f})^2 - 0.09{}",
                        i ? "min(" + balls + ", " : "", place(random), place(random), place(random),
                        i ? ")" : "");
  return balls;
}

}  // namespace

TEST_CASE("pruned tapes have the normals of whole ones") {
  std::mt19937_64 random(3);
  ImplicitSurfaceOptions options = options_of(kProving[2]);
  const std::string balls = union_of_balls(random);
  const ImplicitSurface pruned = surface_of(balls, options);
  options.method.prune = false;
  const ImplicitSurface whole = surface_of(balls, options);
  const View view(frame(whole.bounds(), {}, 1), 160, 160);
  const auto s = make_streams();
  const auto a = std::make_unique<DressedHits>(), b = std::make_unique<DressedHits>();
  int many = 0;
  for (int tile = 0; tile < 100; ++tile) {
    view.fill(tile % 10, tile / 10, 0.5, 0.5, s->rays);
    const HitStream hits = first_hits(whole, s->rays);
    pruned.dress(s->rays, hits, {.normal = true, .value = true}, *a);
    whole.dress(s->rays, hits, {.normal = true, .value = true}, *b);
    int seen = 0;
    for (int i = 0; i < s->rays.size; ++i) {
      if (!is_hit(hits, i)) continue;
      ++seen;
      REQUIRE(a->value[i] == b->value[i]);
      for (int axis = 0; axis < 3; ++axis) REQUIRE(a->normal[axis][i] == b->normal[axis][i]);
    }
    many += seen > 64;
  }
  CHECK(many > 10);
}

TEST_CASE("pruned tapes prove what whole ones do") {
  std::mt19937_64 random(7);
  const std::string balls = union_of_balls(random);
  for (const std::string& formula :
       {balls, std::string("max(x^2 + y^2 + z^2 - 2, max(-x^2 - y^2 + 0.3, min(abs(y) - 0.4, z^3 - 0.1)))"),
        std::string("if(x > 0.2, x^2 + y^2 - 1, abs(x)*y + z^2 - 0.3)")})
    for (const Choice& method : kProving) {
      INFO(formula.substr(0, 40) << " " << method.method << " " << method.key);
      ImplicitSurfaceOptions options = options_of(method, true);
      const ImplicitSurface pruned = surface_of(formula, options);
      options.method.prune = false;
      const ImplicitSurface whole = surface_of(formula, options);
      int both = 0;
      for (int round = 0; round < 3; ++round) {
        const auto s = random_streams(random);
        const HitStream a = first_hits(pruned, s->rays), b = first_hits(whole, s->rays);
        for (int i = 0; i < s->rays.size; ++i) {
          if (a.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided)
            continue;
          REQUIRE(a.certificate[i] == b.certificate[i]);
          if (a.certificate[i] != Certificate::proved_hit) continue;
          REQUIRE(a.t_lo[i] <= b.t_hi[i]);
          REQUIRE(b.t_lo[i] <= a.t_hi[i]);
          ++both;
        }
      }
      CHECK(both > 50);
    }
}
