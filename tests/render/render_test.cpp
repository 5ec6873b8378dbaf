// The renderer: the same bytes always, depths and normals that are right, only what is needed.
#include <isocast/base/error.h>
#include <isocast/render/render.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <thread>

#include "../volume/make_volume.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const std::vector<Layer> kAll = {Layer::depth, Layer::z,     Layer::normal, Layer::position,
                                 Layer::id,    Layer::value, Layer::cost};

// Signed distance to a sphere of radius 11.3 about the centre of 32^3 samples.
constexpr std::int64_t kN = 32;
constexpr double kCentre = 15.5, kRadius = 11.3;
double sphere(std::int64_t i, std::int64_t j, std::int64_t k) {
  return std::sqrt(std::pow(double(i) - kCentre, 2) + std::pow(double(j) - kCentre, 2) +
                   std::pow(double(k) - kCentre, 2)) -
         kRadius;
}
double tangle(std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto f = [](std::int64_t n) {
    const double x = double(n) / 31 * 5 - 2.5;
    return x * x * (x * x - 5);
  };
  return f(i) + f(j) + f(k) + 11.8;
}

struct Setup {
  Scene scene;
  std::shared_ptr<VolumeSurface> surface;
};
Setup make_scene(double (*f)(std::int64_t, std::int64_t, std::int64_t), const VolumeSurfaceOptions& options) {
  Setup s;
  s.surface = std::make_shared<VolumeSurface>(make_volume({kN, kN, kN}, SampleType::f32, f), options);
  s.scene.objects.push_back(
      {s.surface, std::vector<Material>(options.iso.size(), {.color = {0.8f, 0.5f, 0.3f}})});
  return s;
}

View make_view(const Scene& scene, int width, int height, CameraWishes wishes = {}) {
  return View(frame(scene.bounds(), wishes, double(width) / height), width, height);
}

bool same(const Film& a, const Film& b) {
  const auto equal = [](const std::vector<float>& x, const std::vector<float>& y) {
    if (x.size() != y.size()) return false;
    return x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) == 0;
  };
  bool all = equal(a.color(), b.color());
  for (int i = 0; i < kLayerCount; ++i)
    all = all && equal(a.layer(static_cast<Layer>(i)), b.layer(static_cast<Layer>(i)));
  return all;
}

}  // namespace

TEST_CASE("the same bytes for every number of threads and every instruction set") {
  VolumeSurfaceOptions options = surface_options(0, Isa::scalar);
  options.iso = {0, 3};
  Setup s = make_scene(tangle, options);
  s.scene.lights = {{1, -2, 2}};
  s.scene.shadows = true;
  const View view = make_view(s.scene, 97, 75);
  RenderSettings settings;
  settings.spp = 3;
  Film expected(97, 75, kAll);
  render(s.scene, view, settings, expected);
  REQUIRE(std::ranges::any_of(expected.layer(Layer::depth), [](float t) { return std::isfinite(t); }));
  for (const Isa isa : available_isas()) {
    options.isa = isa;
    s.surface->set_options(options);
    for (const int threads : {1, 2, 7}) {
      const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                              static_cast<std::size_t>(threads));
      Film film(97, 75, kAll);
      render(s.scene, view, settings, film);
      INFO(name_of(isa) << ", " << threads << " threads");
      REQUIRE(same(expected, film));
    }
  }
}

TEST_CASE("depth, normal, position and z of a sphere are those of the sphere") {
  for (const bool orthographic : {false, true}) {
    const Setup s = make_scene(sphere, surface_options(0));
    CameraWishes wishes;
    if (orthographic) wishes.ortho_height = 40;
    const View view = make_view(s.scene, 64, 48, wishes);
    Film film(64, 48, kAll);
    const RenderCounts counts = render(s.scene, view, {}, film);
    REQUIRE(counts.primary == 64 * 48);
    REQUIRE(counts.hits + counts.misses == counts.primary);
    REQUIRE(counts.hits > 200);
    RayStream rays;
    double worst = 0;
    std::int64_t wrong = 0;
    for (int ty = 0; ty < 3; ++ty)
      for (int tx = 0; tx < 4; ++tx) {
        view.fill(tx, ty, 0.5, 0.5, rays);
        for (int i = 0; i < rays.size; ++i) {
          if (rays.t_min[i] > rays.t_max[i]) continue;
          const Double3 o = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} - Double3{kCentre, kCentre, kCentre},
                        d = {rays.dx[i], rays.dy[i], rays.dz[i]};
          const double b = dot(o, d), c = dot(o, o) - kRadius * kRadius, disc = b * b - c;
          const std::uint32_t id = rays.id[i];
          const float depth = *film.at(Layer::depth, id);
          wrong += std::isfinite(depth) != (disc >= 0) && std::abs(disc) > 0.5;
          if (!std::isfinite(depth) || disc < 4) continue;
          worst = std::max(worst, std::abs(depth - (-b - std::sqrt(disc))) * std::sqrt(disc) / kRadius);
          const Double3 p = o + double(depth) * d;
          const float* n = film.at(Layer::normal, id);
          REQUIRE(dot({n[0], n[1], n[2]}, normalized(p)) > 0.99);
          const float* position = film.at(Layer::position, id);
          for (int a = 0; a < 3; ++a) REQUIRE(position[a] == Approx(p[a] + kCentre).margin(1e-4));
          REQUIRE(*film.at(Layer::z, id) == Approx(depth * dot(d, view.forward())));
          REQUIRE(*film.at(Layer::id, id) == 1);
          REQUIRE(std::abs(*film.at(Layer::value, id)) < 1e-4);
          REQUIRE(*film.at(Layer::cost, id) >= 1);
        }
      }
    CHECK(wrong == 0);
    CHECK(worst <
          2 / (kRadius - 1) /
              8);  // along the normal: h^2/8 times the largest Laplacian in the cells it crosses, h = 1
  }
}

TEST_CASE("a convex body casts no shadow on itself, a second one does") {
  Setup s = make_scene(sphere, surface_options(0));
  s.scene.lights = {{1, -1, 1}};
  const View view = make_view(s.scene, 128, 128);
  Film lit(128, 128, {}), shadowed(128, 128, {});
  render(s.scene, view, {}, lit);
  s.scene.shadows = true;
  const RenderCounts counts = render(s.scene, view, {}, shadowed);
  CHECK(counts.shadow > 1000);
  std::int64_t different = 0;
  for (std::uint32_t i = 0; i < 128 * 128; ++i) different += lit.color(i)[0] != shadowed.color(i)[0];
  CHECK(different <= 20);  // facets of the interpolant at grazing light

  Setup tangled = make_scene(tangle, surface_options(0));
  tangled.scene.lights = {{1, -1, 1}};
  render(tangled.scene, view, {}, lit = Film(128, 128, {}));
  tangled.scene.shadows = true;
  render(tangled.scene, view, {}, shadowed = Film(128, 128, {}));
  different = 0;
  for (std::uint32_t i = 0; i < 128 * 128; ++i) different += lit.color(i)[0] > shadowed.color(i)[0];
  CHECK(different > 100);
}

TEST_CASE("nothing is computed that neither shading nor a layer asks for") {
  const Setup s = make_scene(sphere, surface_options(0));
  RenderSettings settings;
  const auto has = [](const std::vector<std::string>& list, const char* name) {
    return std::ranges::find(list, name) != list.end();
  };
  settings.colors = false;
  const Features depth_only = find_features(s.scene, Film(4, 4, {Layer::depth}), settings);
  CHECK_FALSE(
      (depth_only.first_sample.normal || depth_only.first_sample.position || depth_only.first_sample.value));
  CHECK(has(depth_only.left_out, "normals"));
  CHECK(has(depth_only.left_out, "positions"));
  CHECK(has(depth_only.left_out, "shading"));
  settings.colors = true;
  const Features shaded = find_features(s.scene, Film(4, 4, {}), settings);
  CHECK((shaded.first_sample.normal && !shaded.first_sample.position && !shaded.first_sample.value));
  CHECK(has(shaded.used, "normals"));
  CHECK(has(shaded.left_out, "shadows"));

  // the film without shading stays empty of colour
  settings.colors = false;
  Film film(16, 16, {Layer::depth});
  render(s.scene, make_view(s.scene, 16, 16), settings, film);
  CHECK(std::ranges::all_of(film.color(), [](float c) { return c == 0; }));
  CHECK(std::ranges::any_of(film.layer(Layer::depth), [](float t) { return std::isfinite(t); }));
}

TEST_CASE("a stop request ends the frame with Interrupted") {
  const Setup s = make_scene(sphere, surface_options(0));
  std::stop_source source;
  source.request_stop();
  Film film(64, 64, {});
  CHECK_THROWS_AS(render(s.scene, make_view(s.scene, 64, 64), {}, film, source.get_token()), Interrupted);
}

TEST_CASE("cameras that cannot look are refused") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  CameraWishes wishes;
  wishes.position = wishes.target = Double3{1, 2, 3};
  CHECK_THROWS_WITH(frame(box, wishes, 1), Catch::Contains("same point"));
  wishes = {};
  wishes.fov = 180;
  CHECK_THROWS_WITH(frame(box, wishes, 1), Catch::Contains("between 0 and 180"));
  wishes = {};
  wishes.position = Double3{0.5, 0.5, 9};
  wishes.up = Double3{0, 0, 1};
  CHECK_THROWS_WITH(frame(box, wishes, 1), Catch::Contains("up vector"));
  wishes.up.reset();
  CHECK(frame(box, wishes, 1).up == Double3{0, 1, 0});
  wishes.position = Double3{std::nan(""), 0, 0};
  CHECK_THROWS_WITH(frame(box, wishes, 1), Catch::Contains("finite"));
}

// Depth (one float) and normal (three) of 64 x 64 pixels, little-endian; written anew where
// ISOCAST_UPDATE_GOLDEN is set.
TEST_CASE("depth and normal of the tangle are those of the golden picture") {
  const Setup s = make_scene(tangle, surface_options(0));
  Film film(64, 64, {Layer::depth, Layer::normal});
  render(s.scene, make_view(s.scene, 64, 64), {}, film);
  std::vector<float> picture = film.layer(Layer::depth);
  picture.insert(picture.end(), film.layer(Layer::normal).begin(), film.layer(Layer::normal).end());
  const std::string path = std::string(GOLDEN_DIR) + "/tangle_depth_normal.raw";
  const auto bytes = static_cast<std::streamsize>(picture.size() * sizeof(float));
  if (std::getenv("ISOCAST_UPDATE_GOLDEN"))
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(picture.data()), bytes);
  std::vector<float> golden(picture.size());
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in.read(reinterpret_cast<char*>(golden.data()), bytes));
  std::size_t different = 0;
  for (std::size_t i = 0; i < golden.size(); ++i) {
    const bool both_far = std::isinf(golden[i]) && std::isinf(picture[i]);
    different +=
        !both_far && !(std::abs(golden[i] - picture[i]) <= 1e-5f * std::max(1.0f, std::abs(golden[i])));
  }
  CHECK(different == 0);
}
