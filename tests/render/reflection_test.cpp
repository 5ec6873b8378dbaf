// Reflections against closed forms.
#include <isocast/render/shade.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "../volume/make_volume.h"
#include "formula_scene.h"
#include "sky.h"

using namespace isocast;
using namespace isocast::test;

namespace {

double difference(const Color& a, const Color& b) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(double(a[c]) - double(b[c])));
  return largest;
}

// The rays of a picture, pixel by pixel: test(id, origin, direction).
template <class Test> void for_each_ray(const View& view, Test test) {
  const auto rays = std::make_unique<RayStream>();
  for (int ty = 0; ty * kTileSize < view.height(); ++ty)
    for (int tx = 0; tx * kTileSize < view.width(); ++tx) {
      view.fill(tx, ty, 0.5, 0.5, *rays);
      for (int i = 0; i < rays->size; ++i)
        if (rays->t_min[i] <= rays->t_max[i])
          test(rays->id[i], Double3{rays->ox[i], rays->oy[i], rays->oz[i]},
               Double3{rays->dx[i], rays->dy[i], rays->dz[i]});
    }
}
// The roots of |o + t d| = 1, |d| = 1.
struct Roots {
  double near, far, discriminant;
};
Roots unit_sphere(const Double3& o, const Double3& d) {
  const double b = dot(o, d), discriminant = b * b - dot(o, o) + 1,
               root = std::sqrt(std::max(0.0, discriminant));
  return {-b - root, -b + root, discriminant};
}
Double3 mirrored(const Double3& d, const Double3& n) { return d - 2 * dot(d, n) * n; }

}  // namespace

TEST_CASE("a mirroring sphere shows the sky where the mirrored ray goes") {
  Scene scene;
  scene.environment = make_sky();
  const View view = view_along({3, -8, 5}, {0, 0, 0}, 48, 3);
  for (const float reflectivity : {1.0f, 0.25f}) {
    scene.objects.clear();
    const Color color = {0.8f, 0.4f, 0.2f};
    add_formula(scene, "x^2 + y^2 + z^2 - 1", {{color, 1, reflectivity}});
    Film film(48, 48, {});
    const RenderCounts counts = render(scene, view, {}, film);
    CHECK(counts.reflection == counts.hits);
    double worst = 0, worst_behind = 0;
    int seen = 0;
    for_each_ray(view, [&](std::uint32_t id, const Double3& o, const Double3& d) {
      const Roots t = unit_sphere(o, d);
      const float* pixel = film.color(id);
      const Color found = {pixel[0], pixel[1], pixel[2]};
      if (t.discriminant < 0) {
        worst_behind = std::max(worst_behind, difference(found, sky_towards(d)));
        CHECK(pixel[3] == 0);
        return;
      }
      if (t.discriminant < 0.01) return;
      ++seen;
      const Double3 n = o + t.near * d, eye = -1.0 * d;
      const Color dull = ambient(color), shine = lit({color}, n, eye, eye), sky = sky_towards(mirrored(d, n));
      Color expected;
      for (int c = 0; c < 3; ++c)
        expected[c] = (1 - reflectivity) * (dull[c] + shine[c]) + reflectivity * sky[c];
      worst = std::max(worst, difference(found, expected));
    });
    CHECK(seen > 500);
    CHECK(worst < 2e-3);
    CHECK(worst_behind < 2e-3);
  }
}

TEST_CASE("the inside of a sphere mirrors its far side, not the start of the ray") {
  const Color color = {0.8f, 0.4f, 0.2f};
  const Double3 light = {0, 0, 1};
  Camera camera;
  camera.position = {0, -0.5, 0.1};
  camera.target = {0.1, 0, 0};
  camera.up = {0, 0, 1};
  camera.fov = 100;
  const View view(camera, 40, 40);
  for (const bool precise : {false, true}) {
    Scene scene;
    scene.lights = {light};
    scene.objects.push_back({formula_surface("x^2 + y^2 + z^2 - 1", {0}, 0, precise), {{color, 1, 1}}});
    Film film(40, 40, {});
    const RenderCounts counts = render(scene, view, {}, film);
    CHECK(counts.reflection == 40 * 40);
    double worst = 0;
    for_each_ray(view, [&](std::uint32_t id, const Double3& o, const Double3& d) {
      const Double3 p = o + unit_sphere(o, d).far * d, r = mirrored(d, p), q = p - 2 * dot(p, r) * r;
      const Color dull = ambient(color), shine = lit({color}, -1.0 * q, light, -1.0 * r);
      const float* pixel = film.color(id);
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(double(pixel[c]) - (dull[c] + shine[c])));
    });
    CHECK(worst < (precise ? 1e-5 : 1e-3));
  }
}

TEST_CASE("the inside of a sampled sphere mirrors its far side") {
  constexpr int n = 33;
  const auto volume =
      make_volume({n, n, n}, SampleType::f32, [](std::int64_t i, std::int64_t j, std::int64_t k) {
        return std::sqrt(double((i - 16) * (i - 16) + (j - 16) * (j - 16) + (k - 16) * (k - 16)));
      });
  VolumeSurfaceOptions options = surface_options(13.3);
  options.normals = NormalKind::difference;
  Scene scene;
  scene.lights = {{0, 0, 1}};
  scene.objects.push_back({std::make_shared<VolumeSurface>(volume, options), {{{1, 1, 1}, 1, 1}}});
  Camera camera;
  camera.position = {16, 10, 17};
  camera.target = {17, 16, 16};
  camera.up = {0, 0, 1};
  camera.fov = 100;
  const View view(camera, 40, 40);
  Film film(40, 40, {});
  CHECK(render(scene, view, {}, film).reflection == 40 * 40);
  int wrong = 0;
  for_each_ray(view, [&](std::uint32_t id, const Double3& o, const Double3& d) {
    const Double3 from = (1 / 13.3) * (o - Double3{16, 16, 16});
    const Double3 p = from + unit_sphere(from, d).far * d, r = mirrored(d, p), q = p - 2 * dot(p, r) * r;
    const Color dull = ambient({1, 1, 1}), shine = lit({{1, 1, 1}}, -1.0 * q, {0, 0, 1}, -1.0 * r);
    wrong += std::abs(film.color(id)[0] - (dull[0] + shine[0])) > 0.05;
  });
  CHECK(wrong == 0);
}

TEST_CASE("a mirroring plane shows the second hit where it is") {
  Scene scene;
  scene.background = {0.1f, 0.2f, 0.3f};
  scene.lights = {{1, -1, 2}};
  const Double3 light = normalized(scene.lights[0]), center = {0, 0, 1.2};
  const Color color = {0.8f, 0.4f, 0.2f};
  add_formula(scene, "z", {{{1, 1, 1}, 1, 1}});
  add_formula(scene, "x^2 + y^2 + (z - 1.2)^2 - 1", {{color, 1}});
  const View view = view_along({0, -5, 4}, {0, -1.5, 0}, 40, 2.5);
  Film film(40, 40, {});
  CHECK(render(scene, view, {}, film).reflection > 800);
  int seen = 0;
  double worst = 0;
  for_each_ray(view, [&](std::uint32_t id, const Double3& o, const Double3& d) {
    const double t = -o[2] / d[2];
    const Double3 p = o + t * d, r = {d[0], d[1], -d[2]};
    if (std::abs(p[0]) > 2.9 || std::abs(p[1]) > 2.9) return;
    const Roots direct = unit_sphere(o - center, d), second = unit_sphere(p - center, r);
    if (direct.discriminant > -0.01 || std::abs(second.discriminant) < 0.01) return;
    Color expected = scene.background;
    if (second.discriminant > 0) {
      ++seen;
      const Double3 normal = (p - center) + second.near * r;
      const Color dull = ambient(color), shine = lit({color}, normal, light, -1.0 * r);
      for (int c = 0; c < 3; ++c) expected[c] = dull[c] + shine[c];
    }
    const float* pixel = film.color(id);
    worst = std::max(worst, difference({pixel[0], pixel[1], pixel[2]}, expected));
  });
  CHECK(seen > 200);
  CHECK(worst < 1e-5);
}

TEST_CASE("rays go to and fro between two mirrors as often as asked") {
  Scene scene;
  scene.background = {0, 1, 0};
  const Color grey = {0.5f, 0.5f, 0.5f};
  add_formula(scene, "x^2 - 1", {{grey, 1, 0.5f}});
  RenderSettings settings;
  for (const int bounces : {0, 1, 2, 5}) {
    settings.reflections = bounces;
    const Pixel pixel = pixel_along(scene, {0, 0, 0}, {1, 0, 0}, settings);
    CHECK(pixel.counts.reflection == bounces);
    CHECK(pixel.color[0] == Approx(0.9 * 0.5 + 0.12));  // the mirrors look the same from everywhere
    CHECK(pixel.alpha == 1);
  }
  // the second mirrored ray leaves through the open side
  settings.reflections = 16;
  const Pixel pixel = pixel_along(scene, {0, 0, 0}, {1, 0, 0.8}, settings);
  CHECK(pixel.counts.reflection == 2);
  CHECK(pixel.color[1] > pixel.color[0] + 0.2f);
}

TEST_CASE("what is mirrored in front is seen through what is in front of it") {
  Scene scene;
  scene.background = {0, 0, 0};
  add_formula(scene, "y", {{{1, 1, 1}, 0.5f, 1}});  // half mirror, half window
  add_formula(scene, "y - 2", {{{0.6f, 0.4f, 0.2f}, 1}});
  const Pixel pixel = pixel_along(scene, {0, -2, 0}, {0, 0, 0});
  CHECK(pixel.counts.reflection == 1);
  CHECK(pixel.color[0] == Approx(0.5 * (0.9 * 0.6 + 0.12)));
  CHECK(pixel.alpha == 1);
}
