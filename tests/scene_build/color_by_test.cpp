// Colours by another field, at the exact hit.
#include <input_error.h>
#include <isocast/apps/scene_build/color_by.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/volume/volume_sampler.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>

#include "made_scene.h"

using namespace isocast;
using test::says;

namespace {

Color color_at(const ColorBy& description, const Double3& point) {
  Color color;
  VolumeLibrary library;
  make_color_field(description, library)->find_colors({&point, 1}, {&color, 1});
  return color;
}
ColorBy by(const std::string& formula) { return {.field = FormulaSource{parse_expression(formula), {}}}; }

}  // namespace

TEST_CASE("a formula's value chooses the colour") {
  ColorBy colors = by("x+y*z");
  colors.range = {2, 4};
  colors.map = "grey";
  const ColorMap grey = color_map_from_name("grey");
  CHECK(color_at(colors, {1, 2, 1}) == grey.at(0.5));
  CHECK(color_at(colors, {9, 0, 0}) == grey.at(1));
  colors = by("sqrt(x)");
  colors.nan_color = {0, 1, 0};
  CHECK(color_at(colors, {-1, 0, 0}) == Color{0, 1, 0});
}

TEST_CASE("a logarithmic map") {
  ColorBy colors = by("x");
  colors.range = {1, 10000};
  colors.logarithmic = true;
  colors.map = "grey";
  CHECK(color_at(colors, {100, 0, 0})[0] == Approx(color_map_from_name("grey").at(0.5)[0]));
  CHECK(color_at(colors, {-1, 0, 0}) == Color{0.5f, 0.5f, 0.5f});
}

TEST_CASE("a volume's values are interpolated, and have a range of their own") {
  const test::TemporaryFolder folder;
  test::write_nrrd(folder / "ramp.nrrd", 5, 0, 4,
                   [](double x, double y, double z) { return x + 10 * y + 100 * z; });
  const VolumeSampler sampler(std::make_shared<const Volume>(read_volume(folder / "ramp.nrrd")));
  CHECK(sampler.value_at({1.25, 0.5, 3}) == Approx(306.25));
  CHECK(sampler.value_at({4, 4, 4}) == Approx(444));
  CHECK(sampler.value_at({0, 0, 0}) == Approx(0));
  CHECK(std::isnan(sampler.value_at({4.1, 0, 0})));
  CHECK(std::isnan(sampler.value_at({std::nan(""), 0, 0})));
  ColorBy colors{.field = VolumeSource{folder / "ramp.nrrd", {}}};
  CHECK(color_at(colors, {2, 2, 2}) == color_map_from_name("viridis").at(0.5));
  CHECK(color_at(colors, {9, 9, 9}) == Color{0.5f, 0.5f, 0.5f});
}

TEST_CASE("ParaView's maps are read, and told when they cannot be") {
  const test::TemporaryFolder folder;
  const auto map = [&](const std::string& text) {
    std::ofstream(folder / "map.json") << text;
    return read_color_map((folder / "map.json").string());
  };
  const ColorMap two = map(R"([{"Name": "two", "RGBPoints": [-5, 1, 0, 0, 5, 0, 0, 1]}])");
  CHECK(two.at(0) == Color{1, 0, 0});
  CHECK(two.at(1) == Color{0, 0, 1});
  const ColorMap nan = map(R"([{"NanColor": [1, 1, 0], "RGBPoints": [-5, 1, 0, 0, 5, 0, 0, 1]}])");
  CHECK(nan.at(std::nan("")) == Color{1, 1, 0});
  ColorBy colors = by("sqrt(x)");
  colors.map = (folder / "map.json").string();
  CHECK(color_at(colors, {-1, 0, 0}) == Color{1, 1, 0});
  colors.nan_color = {0, 1, 0};
  CHECK(color_at(colors, {-1, 0, 0}) == Color{0, 1, 0});
  for (const char* const text :
       {"[]", "{}", R"([{"RGBPoints": [0, 1, 1]}])", R"([{"RGBPoints": [1, 0, 0, 0, 0, 1, 1, 1]}])",
        R"([{"RGBPoints": [0, "a", 0, 0, 1, 1, 1, 1]}])", "[", "3",
        R"([{"RGBPoints": [0, 0, 0, 0, 1, 1, 1, 1], "NanColor": [1, 1]}])"})
    CHECK_THROWS_AS(map(text), InputError);
  CHECK_THROWS_MATCHES(map(R"([{"RGBPoints": [0, 1, 1]}])"), InputError, says("found 3 numbers"));
}

TEST_CASE("hits take their colour where they are") {
  const BuiltScene scene = test::built(
      R"({"type": "formula", "expr": "x^2+y^2+z^2-1", "domain": [[-1.5,1.5],[-1.5,1.5],[-1.5,1.5]],
          "color_by": {"expr": "x", "map": "grey", "range": [-1, 1]}}, {"type": "formula", "expr": "z+3", "domain": [[-9,9],[-9,9],[-4,-2]]})");
  const View view = test::looking(scene.scene, {0, 0, 20}, {0, 0, 0}, 65, 2);
  Film film(65, 65, {Layer::position, Layer::normal});
  (void)render(scene.scene, view, {}, film);
  const std::uint32_t left = 16 + 65 * 32, right = 48 + 65 * 32;
  // the same light on both sides
  CHECK(film.color(right)[0] > 4 * film.color(left)[0]);
}
