// Rays that are cut by tiles and packets first: the same roots as without, from any camera.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};

ImplicitSurface surface_of(const char* formula, const char* method, const char* beams, bool precise,
                           Isa isa = widest_isa()) {
  ImplicitSurfaceOptions options;
  options.iso = {0, 0.3};
  options.method = choose_formula_method(method, {{"beams", beams}});
  options.double_precision = precise;
  options.isa = isa;
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

}  // namespace

TEST_CASE("beams lose no root and find none", "[property]") {
  std::mt19937_64 random(11);
  std::int64_t hits_seen = 0, compared = 0, rays_seen = 0;
  for (std::int64_t n = 0, count = cases(40, 2000); n < count; ++n) {
    const char* formulas[] = {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                              "sin(4*x)+sin(4*y)+sin(4*z)",
                              "min(x^2+y^2+z^2-1, abs(x-1)+y^2-0.1)",
                              "1/x + y*z",
                              "sqrt(x-0.5) - y*z",
                              "exp(-4*(x^2+y^2)) - z^2"};
    const char* formula = formulas[n % 6];
    const char* method = n % 5 == 0 ? "interval" : "affine";
    const bool precise = n % 2 == 0;
    INFO(formula << " " << method << (precise ? " double" : " float"));
    const ImplicitSurface with = surface_of(formula, method, "1", precise),
                          without = surface_of(formula, method, "0", precise),
                          scalar = surface_of(formula, method, "1", precise, Isa::scalar);
    const View view(random_camera(random), 32, 32);
    RayStream rays;
    for (int tile = 0; tile < 4; ++tile) {
      view.fill(tile % 2, tile / 2, 0.5, 0.5, rays);
      const HitStream a = first_hits(with, rays), b = first_hits(without, rays);
      require_same_bits(a, first_hits(scalar, rays), rays.size);
      for (int i = 0; i < rays.size; ++i) {
        ++rays_seen;
        if (a.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided)
          continue;
        ++compared;
        INFO(std::hexfloat << rays.ox[i] << " " << rays.oy[i] << " " << rays.oz[i] << " towards "
                           << rays.dx[i] << " " << rays.dy[i] << " " << rays.dz[i]);
        REQUIRE(a.certificate[i] == b.certificate[i]);
        if (!is_hit(a, i)) continue;
        ++hits_seen;
        REQUIRE(a.t_lo[i] <= b.t_hi[i]);
        REQUIRE(b.t_lo[i] <= a.t_hi[i]);
        REQUIRE(a.iso[i] == b.iso[i]);
        REQUIRE(a.sides[i] == b.sides[i]);
      }
    }
  }
  CHECK(compared > 0.9 * static_cast<double>(rays_seen));
  CHECK(hits_seen > 4000);
}
