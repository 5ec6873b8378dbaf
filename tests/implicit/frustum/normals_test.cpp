// Normals through the Jacobian of the frustum form's map, held against the gradient of the formula.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};
constexpr const char* kTangle = "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8";
constexpr const char* kFormulas[] = {kTangle, "x - 0.3*y + 0.2", "x^2*y^3 + z^5 - x*y*z - 0.4",
                                     "(x^2+y^2+z^2)^5 - 3*x^4*y^4*z^2 - 1"};

ImplicitSurface surface_of(const char* formula, const char* gradient, bool precise, Isa isa = widest_isa(),
                           NormalKind normals = NormalKind::gradient) {
  ImplicitSurfaceOptions options;
  options.iso = {0, 0.3};
  options.method = choose_formula_method("frustum-lr", {{"gradient", gradient}});
  options.double_precision = precise;
  options.isa = isa;
  options.normals = normals;
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

DressedHits dressed(const Surface& surface, const RayStream& rays, const HitStream& hits,
                    const DressWishes& wishes = {.normal = true}) {
  DressedHits result = {};
  surface.dress(rays, hits, wishes, result);
  return result;
}
Double3 normal_at(const DressedHits& looks, int i) {
  return {looks.normal[0][i], looks.normal[1][i], looks.normal[2][i]};
}

}  // namespace

TEST_CASE("normals of the form are those of the formula, from any camera") {
  std::mt19937_64 random(5);
  for (const bool precise : {true, false}) {
    int seen = 0, close = 0, same = 0;
    for (int n = 0; n < 24; ++n) {
      const char* const formula = kFormulas[n % 4];
      const View view(random_camera(random), 150, 140);
      const ImplicitSurface form = surface_of(formula, "form", precise),
                            plain = surface_of(formula, "formula", precise);
      if (!form.primary(view)) continue;
      INFO(formula << (precise ? " double" : " float"));
      each_tile_of_pass(form, view, [&](const RayStream& rays, const HitStream& hits) {
        const DressedHits a = dressed(form, rays, hits), b = dressed(plain, rays, hits);
        for (int i = 0; i < rays.size; ++i) {
          if (!is_ray(rays, i) || !is_hit(hits, i)) continue;
          const Double3 found = normal_at(a, i), right = normal_at(b, i);
          ++seen;
          close += length(cross(found, right)) < (precise ? 1e-7 : 1e-3) && dot(found, right) > 0;
          same += found == right;
        }
      });
    }
    CHECK(seen > 20000);
    CHECK(close > (precise ? 0.999 : 0.98) * seen);
    // they are other numbers
    CHECK(same < 0.5 * seen);
  }
}

TEST_CASE("normals of the form have the same bits on every instruction set") {
  const View view(frame({{-2, -2, -2}, {2, 2, 2}}, {}, 1), 128, 128);
  const auto look = [&](Isa isa) {
    std::vector<DressedHits> result;
    const ImplicitSurface surface = surface_of(kTangle, "form", false, isa);
    each_tile_of_pass(surface, view, [&](const RayStream& rays, const HitStream& hits) {
      result.push_back(dressed(surface, rays, hits));
    });
    return result;
  };
  const std::vector<DressedHits> first = look(available_isas().front());
  for (const Isa isa : available_isas()) {
    const std::vector<DressedHits> other = look(isa);
    for (std::size_t tile = 0; tile < first.size(); ++tile)
      for (int i = 0; i < kStreamSize; ++i) REQUIRE(normal_at(first[tile], i) == normal_at(other[tile], i));
  }
}

TEST_CASE("rays without a form, and who asks for other normals, have the formula's") {
  const View view(frame({{-2, -2, -2}, {2, 2, 2}}, {}, 1), 128, 128);
  const ImplicitSurface form = surface_of(kTangle, "form", true),
                        plain = surface_of(kTangle, "formula", true),
                        differences = surface_of(kTangle, "form", true, widest_isa(), NormalKind::difference),
                        others = surface_of(kTangle, "formula", true, widest_isa(), NormalKind::difference);
  int seen = 0, behind = 0;
  each_tile_of_pass(form, view, [&](const RayStream& rays, const HitStream& hits) {
    const DressWishes all = {.normal = true, .position = true, .value = true};
    const DressedHits a = dressed(form, rays, hits, all), b = dressed(plain, rays, hits, all),
                      c = dressed(differences, rays, hits), d = dressed(others, rays, hits);
    HitStream next = hits;
    TraceCounts counts;
    form.next_hit(rays, next, counts);
    const DressedHits e = dressed(form, rays, next), f = dressed(plain, rays, next);
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(hits, i)) continue;
      ++seen;
      REQUIRE(a.value[i] == b.value[i]);
      REQUIRE(a.position[2][i] == b.position[2][i]);
      REQUIRE(normal_at(c, i) == normal_at(d, i));
      if (!is_hit(next, i)) continue;
      ++behind;
      REQUIRE(normal_at(e, i) == normal_at(f, i));
    }
  });
  CHECK(seen > 2000);
  CHECK(behind > 1000);
}

TEST_CASE("where the form's gradient vanishes the formula's is taken") {
  const View view(frame({{-2, -2, -2}, {2, 2, 2}}, {}, 1), 256, 256);
  for (const char* const formula : {"(x-y)^3", "0*x"}) {
    const ImplicitSurface form = surface_of(formula, "form", true),
                          plain = surface_of(formula, "formula", true);
    int seen = 0;
    each_tile_of_pass(form, view, [&](const RayStream& rays, const HitStream& hits) {
      const DressedHits a = dressed(form, rays, hits), b = dressed(plain, rays, hits);
      for (int i = 0; i < rays.size; ++i) {
        if (!is_hit(hits, i)) continue;
        ++seen;
        if (normal_at(b, i) == Double3{}) REQUIRE(normal_at(a, i) == Double3{});
        REQUIRE(length(normal_at(a, i)) <= 1 + 1e-12);
      }
    });
    CHECK(seen > 1000);
  }
}
