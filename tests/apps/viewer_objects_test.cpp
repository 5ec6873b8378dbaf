// Scenes of several objects, moved and clipped: what is found out is of one of them.
#include <isocast/apps/viewer/extras.h>
#include <isocast/apps/viewer/make_picture.h>
#include <isocast/apps/viewer/probe_work.h>
#include <isocast/base/error.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "../scene_build/made_scene.h"

using namespace isocast;
using namespace isocast::viewer;

namespace {

constexpr int kSize = 64;

// Side by side, as seen along y: a ball of samples of which the right half is cut off, a formula that is
// moved and twice as large, and a triangle.
struct Example {
  test::TemporaryFolder folder;
  SceneKeeper keeper;
  std::optional<View> view;
  Picture picture;

  Example() {
    test::write_nrrd(folder / "ball.nrrd", 16, -1, 1,
                     [](double x, double y, double z) { return x * x + y * y + z * z; });
    std::ofstream(folder / "one.obj") << "v 4 0 -1\nv 6 0 -1\nv 5 0 1\nf 1 2 3\n";
    std::ofstream(folder / "scene.json")
        << R"({"isocast": 1, "camera": {"position": [1, -20, 0], "target": [1, 0, 0],
      "ortho": 12}, "objects": [
      {"name": "ball", "type": "volume", "file": "ball.nrrd", "iso": 0.5, "clip": [{"plane": [1, 0, 0, 0]}]},
      {"name": "pearl", "type": "formula", "expr": "x^2+y^2+z^2-0.25",
       "transform": {"scale": 2, "translate": [-3, 0, 0]}},
      {"type": "mesh", "file": "one.obj"}]})";
    RenderWords words;
    words.input = folder / "scene.json";
    keeper.show(words);
    view.emplace(frame(keeper.built().scene.bounds(), keeper.description().camera, 1), kSize, kSize);
    picture.film = rendered();
    picture.rgba = screen_pixels(*picture.film, Overlay::none);
    picture.width = picture.height = kSize;
  }
  [[nodiscard]] JobScene job() { return {keeper, *view, picture, {}}; }
  [[nodiscard]] std::shared_ptr<const Film> rendered() {
    const auto film = std::make_shared<Film>(kSize, kSize, std::vector<Layer>());
    render(keeper.built().scene, *view, {}, *film);
    return film;
  }
};
// The column of pixels that sees this x, and the row of z = 0.
int column(double x) { return static_cast<int>(std::floor((x + 5) / 12 * kSize)); }
constexpr int kMiddle = kSize / 2;

}  // namespace

TEST_CASE("a probe is of the object that is hit, without what cuts it") {
  Example example;
  const PixelProbe pearl = probe_pixel(example.job(), column(-3), kMiddle);
  CHECK(pearl.object == "pearl");
  CHECK(pearl.unit == "domain widths");
  REQUIRE(pearl.probe.truth.roots.size() == 2);
  CHECK(pearl.probe.truth.roots[0].lo == Approx(19).margin(0.02));
  REQUIRE(pearl.probe.answers.size() > 10);
  for (const ProbeAnswer& answer : pearl.probe.answers) CHECK(answer.verdict == "right");
  // f along the ray of the world: positive before the first root, negative behind it
  const auto at = [&](double t) {
    const double share = (t - pearl.profile.t0) / (pearl.profile.t1 - pearl.profile.t0);
    return pearl.profile.values.at(static_cast<std::size_t>(share * 1023));
  };
  CHECK(at(18.9) > 0);
  CHECK(at(19.1) < 0);
  CHECK(pearl.profile.t0 == Approx(18));

  const PixelProbe ball = probe_pixel(example.job(), column(-0.3), kMiddle);
  CHECK(ball.object == "ball");
  CHECK(ball.unit == "voxels");
  CHECK(ball.probe.truth.roots.size() == 2);
  CHECK(ball.profile.borders.size() >= 15);
  for (const ProbeAnswer& answer : ball.probe.answers)
    if (answer.method != "midpoint") CHECK(answer.verdict == "right");
  // beside all of them, the one that was chosen: where the ball is cut off, its ray goes on
  const PixelProbe cut = probe_pixel(example.job(), column(0.3), kMiddle, 0);
  CHECK(cut.object == "ball");
  CHECK(cut.probe.truth.roots.size() == 2);
  CHECK(probe_pixel(example.job(), column(0.3), kMiddle, 1).probe.truth.roots.empty());

  const PixelProbe mesh = probe_pixel(example.job(), column(5), kMiddle);
  CHECK(mesh.object == "number 3");
  CHECK(mesh.error == "Only volumes and formulas are probed.");
  CHECK((example.rendered()->color() == example.picture.film->color()));
}

TEST_CASE("errors against the reference are of one object alone") {
  Example example;
  for (const std::size_t object : {0, 1}) {
    Picture errors;
    show_errors(example.job(), object, [&](const Picture& shown) { errors = shown; });
    REQUIRE(errors.rgba.size() == example.picture.rgba.size());
    const auto red = [&](int x) {
      const std::uint8_t* const pixel = &errors.rgba[4 * static_cast<std::size_t>(kMiddle * kSize + x)];
      return pixel[0] == 230 && pixel[1] == 20 && pixel[2] == 20;
    };
    for (int x = 0; x < kSize; ++x) CHECK_FALSE(red(x));
  }
  CHECK_THROWS_AS(other_picture(example.job(), 0, "affine"), InputError);
  const std::vector<std::uint8_t> other = other_picture(example.job(), 0, "midpoint");
  CHECK((other != example.picture.rgba));
  CHECK((other_picture(example.job(), 1, "certified") != other));
  CHECK((example.rendered()->color() == example.picture.film->color()));
}

TEST_CASE("points are of the chosen object's methods") {
  Example example;
  for (const std::size_t object : {0, 1}) {
    std::vector<MethodPoint> points;
    find_points(example.job(), object, [&](const std::vector<MethodPoint>& now) { points = now; });
    CHECK((points.front().method == "midpoint") == (object == 0));
    const auto certified = std::ranges::find(points, "certified", &MethodPoint::method);
    REQUIRE(certified != points.end());
    CHECK(certified->known > 200);
    CHECK(certified->wrong == 0);
    CHECK(certified->error < 1e-3);
    CHECK(certified->ms_per_megaray > 0);
  }
  CHECK((example.rendered()->color() == example.picture.film->color()));
  CHECK_FALSE(example.keeper.has_methods(2));
  CHECK_FALSE(example.keeper.has_methods(3));
}
