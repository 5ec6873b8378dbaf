// Ambient occlusion against form factors.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "formula_scene.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const Material kFloor = {{0.5f, 0.5f, 0.5f}, 1};

// An orthographic view of the floor's middle alone.
double open_share_at_origin(const Scene& scene, int spp) {
  RenderSettings settings;
  settings.spp = spp;
  Film film(1, 1, {});
  render(scene, view_along({0, -0.5, 0.5}, {0, 0, 0}, 1, 1e-6), settings, film);
  return double(film.color(0)[0]) / (0.9 * 0.5);
}

}  // namespace

TEST_CASE("a sphere above a floor keeps out its form factor of the light") {
  for (const double height : {1.0, 1.5, 2.0}) {
    Scene scene;
    scene.ambient_occlusion.samples = 64;
    add_formula(scene, "z", {kFloor});
    CHECK(open_share_at_origin(scene, 1) == Approx(1));
    add_formula(scene, fmt::format("x^2 + y^2 + (z - {})^2 - 0.49", height), {kFloor});
    CHECK(open_share_at_origin(scene, 64) == Approx(1 - 0.49 / (height * height)).margin(2e-3));
  }
}

TEST_CASE("beside a wall half of the light is kept out, as far as the wall is high") {
  // the strip of height h at distance a: (1 - a / sqrt(a^2 + h^2)) / 2 of an endless one; the domain ends at
  // 3
  Scene scene;
  scene.ambient_occlusion.samples = 64;
  add_formula(scene, "z", {kFloor});
  add_formula(scene, "x - 0.05", {kFloor});
  const double endless = 0.5 * (1 - 0.05 / std::sqrt(0.05 * 0.05 + 9));
  CHECK(open_share_at_origin(scene, 64) == Approx(1 - endless).margin(0.01));
}

TEST_CASE("only what is near enough occludes, and what is clear lets light through") {
  Scene scene;
  scene.ambient_occlusion = {64, 0.5};
  add_formula(scene, "z", {kFloor});
  add_formula(scene, "x^2 + y^2 + (z - 1.5)^2 - 0.49", {kFloor});
  CHECK(open_share_at_origin(scene, 4) == Approx(1));
  scene.ambient_occlusion.radius = 3;
  const double dark = open_share_at_origin(scene, 64);
  CHECK(dark == Approx(1 - 0.49 / 2.25).margin(2e-3));
  scene.objects[1].materials[0].opacity = 0.3f;
  CHECK(open_share_at_origin(scene, 64) == Approx(1 - (1 - 0.7 * 0.7) * 0.49 / 2.25).margin(4e-3));
}

TEST_CASE("light from everywhere is one light among others") {
  Scene scene;
  add_formula(scene, "z", {kFloor});
  const auto brightness = [&] { return double(pixel_along(scene, {0, -0.9, 0.9}, {0, 0, 0}).color[0]); };
  scene.lights = {{0, 0, 1}};
  const double one = brightness();
  scene.ambient_occlusion.samples = 8;
  const double ambient = 0.15 * 0.5, around = ambient + 0.75 * 0.5;
  CHECK(brightness() == Approx(ambient + 0.5 * (one - ambient) + 0.5 * (around - ambient)));
  scene.lights.clear();
  CHECK(brightness() == Approx(around));
}

TEST_CASE("the rays of a pixel depend on it and its sample alone") {
  Scene scene;
  scene.ambient_occlusion.samples = 8;
  add_formula(scene, "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", {{{0.8f, 0.6f, 0.4f}}});
  Camera camera;
  camera.position = {4, -9, 6};
  camera.target = {0, 0, 0};
  camera.up = {0, 0, 1};
  camera.ortho_height = 7;
  RenderSettings settings;
  settings.spp = 2;
  Film whole(40, 40, {}), again(40, 40, {}), plain(40, 40, {});
  const RenderCounts counts = render(scene, View(camera, 40, 40), settings, whole);
  render(scene, View(camera, 40, 40), settings, again);
  CHECK(same_films(whole, again));
  CHECK(counts.occlusion > 10 * counts.hits);
  CHECK(counts.shadow == 0);
  scene.ambient_occlusion.samples = 0;
  CHECK(render(scene, View(camera, 40, 40), settings, plain).occlusion == 0);
  CHECK_FALSE(same_films(whole, plain));
}
