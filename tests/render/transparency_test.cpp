// Transparency: layers in order, over objects and iso-values, against colours in closed form.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "../volume/make_volume.h"
#include "formula_scene.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const Color kRed = {0.9f, 0.1f, 0.2f}, kBlue = {0.1f, 0.3f, 0.8f};
const Double3 kFrom = {0, -9, 0}, kTo = {0, 0, 0};

// A surface that faces the eye and its headlight: 15 % ambient, 75 % diffuse, a highlight of 12 %.
Color facing(const Color& color) {
  return {0.9f * color[0] + 0.12f, 0.9f * color[1] + 0.12f, 0.9f * color[2] + 0.12f};
}

struct Layered {
  Color color = {0, 0, 0};
  float through = 1;
};
// Front to back, over white.
Layered composite(const std::vector<Material>& layers) {
  Layered sum;
  for (const Material& layer : layers) {
    const Color shaded = facing(layer.color);
    for (int c = 0; c < 3; ++c) sum.color[c] += sum.through * layer.opacity * shaded[c];
    sum.through *= 1 - layer.opacity;
  }
  for (float& c : sum.color) c += sum.through;
  return sum;
}
void check_pixel(const Pixel& pixel, const std::vector<Material>& layers) {
  const Layered expected = composite(layers);
  for (int c = 0; c < 3; ++c) CHECK(pixel.color[c] == Approx(expected.color[c]).epsilon(1e-5));
  CHECK(pixel.alpha == Approx(1 - expected.through).epsilon(1e-5));
}

}  // namespace

TEST_CASE("nested spheres of one formula are seen through, as deep as asked") {
  const Material shell = {kRed, 0.3f}, core = {kBlue, 0.6f};
  const auto opaque = [](Material m) { return m.opacity = 1, m; };
  for (const bool turned : {false, true}) {  // the order of the iso-values says nothing
    Scene scene;
    add_formula(scene, "x^2 + y^2 + z^2", turned ? std::vector{core, shell} : std::vector{shell, core},
                turned ? std::vector{0.25, 1.0} : std::vector{1.0, 0.25});
    const auto look = [&](int depth) {
      RenderSettings settings;
      settings.transparency_depth = depth;
      return pixel_along(scene, kFrom, kTo, settings);
    };
    check_pixel(look(1), {opaque(shell)});
    check_pixel(look(2), {shell, opaque(core)});
    check_pixel(look(3), {shell, core, opaque(core)});
    for (const int enough : {4, 5, 64}) check_pixel(look(enough), {shell, core, core, shell});
    CHECK(look(2).counts.transparency == 2);
    CHECK(look(64).counts.transparency == 4);
  }
}

TEST_CASE("an opaque core ends the ray, a hidden shell is not there") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2", {{kRed, 0.3f}, {kBlue, 1}}, {1, 0.25});
  const Pixel pixel = pixel_along(scene, kFrom, kTo);
  check_pixel(pixel, {{kRed, 0.3f}, {kBlue, 1}});
  CHECK(pixel.counts.transparency == 1);
  scene.objects[0].materials[0].opacity = 0;
  check_pixel(pixel_along(scene, kFrom, kTo), {{kBlue, 1}});
  RenderSettings shallow;
  shallow.transparency_depth = 1;
  check_pixel(pixel_along(scene, kFrom, kTo, shallow), {});
}

TEST_CASE("the layers of two overlapping objects are taken in order") {
  const Material red = {kRed, 0.5f}, blue = {kBlue, 0.25f};
  const std::string near = "x^2 + (y + 0.51)^2 + z^2 - 1", far = "x^2 + (y - 0.52)^2 + z^2 - 1";
  Scene scene, turned;
  add_formula(scene, near, {red});
  add_formula(scene, far, {blue});
  add_formula(turned, far, {blue});
  add_formula(turned, near, {red});
  for (const Scene* s : {&scene, &turned}) {
    check_pixel(pixel_along(*s, kFrom, kTo), {red, blue, red, blue});
    check_pixel(pixel_along(*s, {0, 9, 0}, kTo), {blue, red, blue, red});
    check_pixel(pixel_along(*s, {0, -9, 1.2}, {0, 0, 1.2}), {});
  }

  // A ball around both, sampled.
  VolumeSurfaceOptions options = surface_options(23);
  options.object = 2;
  options.normals = NormalKind::difference;
  const auto volume =
      make_volume({9, 9, 9}, SampleType::f32, [](std::int64_t i, std::int64_t j, std::int64_t k) {
        return double((i - 4) * (i - 4) + (j - 4) * (j - 4) + (k - 4) * (k - 4)) * 4;
      });
  for (int a = 0; a < 3; ++a) volume->world_from_grid.m[a][3] = -4;
  const Material grey = {{0.5f, 0.5f, 0.5f}, 0.2f};
  scene.objects.push_back({std::make_shared<VolumeSurface>(volume, options), {grey}});
  RenderSettings deep;
  deep.transparency_depth = 6;
  check_pixel(pixel_along(scene, kFrom, kTo, deep), {grey, red, blue, red, blue, grey});
}

TEST_CASE("forty layers of four objects, of several iso-values each, are taken in order") {
  // spheres around points of the ray; their radii never meet
  Scene scene;
  std::vector<std::pair<double, Material>> layers;
  for (int object = 0; object < 4; ++object) {
    std::vector<double> iso;
    std::vector<Material> materials;
    const double center = -0.3 + 0.21 * object;
    for (int i = 0; i < 5; ++i) {
      const double radius = 0.4 + 0.37 * i + 0.013 * object;
      iso.push_back(radius * radius);
      materials.push_back({{0.1f * static_cast<float>(i), 0.2f * static_cast<float>(object), 0.5f},
                           0.02f + 0.03f * static_cast<float>(i)});
      for (const double side : {-1, 1}) layers.push_back({center + side * radius, materials.back()});
    }
    add_formula(scene, fmt::format("x^2 + (y - ({}))^2 + z^2", center), materials, iso);
  }
  std::ranges::sort(layers, {}, [](const auto& layer) { return layer.first; });
  std::vector<Material> order;
  for (const auto& [place, material] : layers) order.push_back(material);
  RenderSettings deep;
  deep.transparency_depth = 64;
  check_pixel(pixel_along(scene, kFrom, kTo, deep), order);
  std::ranges::reverse(order);
  check_pixel(pixel_along(scene, {0, 9, 0}, kTo, deep), order);
  deep.transparency_depth = 17;
  std::ranges::reverse(order);
  order.resize(17);
  order.back().opacity = 1;
  check_pixel(pixel_along(scene, kFrom, kTo, deep), order);
}

TEST_CASE("a ray that an opaque surface ended asks for nothing more") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2 - 1", {{kRed, 1}});
  add_formula(scene, "y - 2.01", {{kBlue, 0.5f}});
  add_formula(scene, "y - 2.5", {{kBlue, 0.5f}});
  Film film(12, 12, {Layer::id});
  const RenderCounts counts = render(scene, view_along(kFrom, kTo, 12, 4), {}, film);
  const auto ended = std::ranges::count(film.layer(Layer::id), 1.0f);
  CHECK(ended > 20);
  CHECK(counts.transparency == 2 * (12 * 12 - ended));
}

TEST_CASE("layers are those of the first hit, and opaque pictures need no further one") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2", {{kRed, 1}, {kBlue, 1}}, {1, 0.25});
  const View view = view_along({4, -9, 3}, kTo, 40, 3);
  const std::vector<Layer> layers = {Layer::depth, Layer::z,     Layer::normal, Layer::position,
                                     Layer::id,    Layer::value, Layer::cost,   Layer::certificate};
  Film opaque(40, 40, layers), clear(40, 40, layers);
  CHECK(render(scene, view, {}, opaque).transparency == 0);
  scene.objects[0].materials[0].opacity = 0.5f;
  CHECK(render(scene, view, {}, clear).transparency > 100);
  CHECK_FALSE(same_bytes(opaque.color(), clear.color()));
  for (const Layer layer : layers) {
    INFO(name_of(layer));
    CHECK(same_bytes(opaque.layer(layer), clear.layer(layer)));
  }
}

TEST_CASE("what is not opaque lets light through") {
  Scene scene;
  scene.lights = {{0, 0, 1}};
  scene.shadows = true;
  const Material floor = {{0.5f, 0.5f, 0.5f}, 1};
  add_formula(scene, "z", {floor});
  const auto brightness = [&] { return pixel_along(scene, {0, -9, 3}, {0, 0, 0}).color[0]; };
  const float lit = brightness();
  add_formula(scene, "x^2 + y^2 + (z - 2)^2 - 0.25", {{kRed, 1}});
  const float dark = brightness();
  CHECK(dark == Approx(0.15 * 0.5));
  scene.objects[1].materials[0].opacity = 0.4f;
  CHECK(brightness() == Approx(dark + 0.6f * 0.6f * (lit - dark)).epsilon(1e-5));
  scene.objects[1].materials[0].opacity = 0;
  CHECK(brightness() == Approx(lit));
}
