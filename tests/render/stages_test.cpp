// The stages of a picture together: several lights, the same bytes with everything on, nothing without need.
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "../volume/make_volume.h"
#include "formula_scene.h"
#include "sky.h"

using namespace isocast;
using namespace isocast::test;

TEST_CASE("several lights give the mean of what each gives, with its shadow") {
  Scene scene;
  const Material material = {{0.8f, 0.6f, 0.4f}};
  add_formula(scene, "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", {material});
  scene.shadows = true;
  const View view = view_along({4, -9, 6}, {0, 0, 0}, 48, 7);
  const std::vector<Double3> lights = {{1, -1, 2}, {-3, -1, 1}, {0, 0, 1}, {2, -2, -1}};
  Film all(48, 48, {});
  scene.lights = lights;
  const RenderCounts counts = render(scene, view, {}, all);
  std::vector<double> sum(48 * 48 * 4);
  std::int64_t shadow_rays = 0;
  for (const Double3& light : lights) {
    Film one(48, 48, {});
    scene.lights = {light};
    shadow_rays += render(scene, view, {}, one).shadow;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += double(one.color()[i]);
  }
  CHECK(counts.shadow == shadow_rays);
  double worst = 0;
  for (std::size_t i = 0; i < sum.size(); ++i)
    worst = std::max(worst, std::abs(sum[i] / 4 - double(all.color()[i])));
  CHECK(worst < 1e-6);
}

TEST_CASE("with everything on, the same bytes for every number of threads and every instruction set") {
  VolumeSurfaceOptions options = surface_options(0, Isa::scalar);
  options.iso = {0, 3};
  const auto f = [](std::int64_t n) {
    const double x = double(n) / 31 * 5 - 2.5;
    return x * x * (x * x - 5);
  };
  const auto surface = std::make_shared<VolumeSurface>(
      make_volume({32, 32, 32}, SampleType::f32,
                  [&](std::int64_t i, std::int64_t j, std::int64_t k) { return f(i) + f(j) + f(k) + 11.8; }),
      options);
  Scene scene;
  scene.objects.push_back({surface, {{{0.8f, 0.5f, 0.3f}, 0.6f, 0.4f}, {{0.2f, 0.5f, 0.9f}, 0.3f, 0.2f}}});
  add_formula(scene, "(x - 1)^2 + y^2 + z^2 - 4", {{{0.3f, 0.9f, 0.3f}, 0.5f, 0.7f}});
  scene.lights = {{1, -2, 2}, {-1, -1, 0}};
  scene.shadows = true;
  scene.environment = make_sky(32, 16);
  const View view(frame(scene.bounds(), {}, 1), 48, 48);
  RenderSettings settings;
  settings.spp = 2;
  settings.reflections = 3;
  const std::vector<Layer> layers = {Layer::depth, Layer::normal, Layer::id, Layer::cost};
  Film expected(48, 48, layers);
  const RenderCounts counts = render(scene, view, settings, expected);
  CHECK(counts.reflection > 1000);
  CHECK(counts.transparency > 1000);
  for (const Isa isa : available_isas())
    for (const int threads : {1, 2, 7}) {
      if (threads != 2 && isa != Isa::scalar) continue;
      options.isa = isa;
      surface->set_options(options);
      const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                              static_cast<std::size_t>(threads));
      Film film(48, 48, layers);
      render(scene, view, settings, film);
      INFO(name_of(isa) << ", " << threads << " threads");
      CHECK(same_films(expected, film));
    }
}

TEST_CASE("stages run only where a material or the scene asks for them") {
  Scene scene;
  add_formula(scene, "x", {{{1, 1, 1}}});
  const auto has = [](const std::vector<std::string>& list, const char* name) {
    return std::ranges::find(list, name) != list.end();
  };
  RenderSettings settings;
  settings.reflections = 5;
  const Film film(4, 4, {});
  const Features plain = find_features(scene, film, settings);
  for (const char* name : {"transparency", "reflections", "environment", "lights", "shadows"}) {
    INFO(name);
    CHECK(has(plain.left_out, name));
  }
  CHECK_FALSE(plain.transparency);
  CHECK(plain.reflections == 0);
  scene.objects[0].materials[0] = {{1, 1, 1}, 0.5f, 0.5f};
  scene.environment = make_sky(2, 1);
  scene.lights = {{0, 0, 1}, {1, 0, 0}};
  const Features all = find_features(scene, film, settings);
  for (const char* name : {"transparency:4", "reflections:5", "environment", "lights:2"}) {
    INFO(name);
    CHECK(has(all.used, name));
  }
  settings.colors = false;
  const Features none = find_features(scene, film, settings);
  CHECK_FALSE(none.transparency);
  CHECK(none.reflections == 0);
}
