// From descriptions to surfaces: where things stand, what they are made of, how many they are.
#include <input_error.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>

#include "made_scene.h"

using namespace isocast;
using test::built;
using test::first_hit;
using test::says;

namespace {

const char* const kBall =
    R"("type": "formula", "expr": "x^2+y^2+z^2-1", "domain": [[-1.5,1.5],[-1.5,1.5],[-1.5,1.5]])";

std::string record(const std::string& keys) { return std::string("{").append(keys).append("}"); }
std::string ball(const std::string& more) { return record(std::string(kBall).append(more)); }

const char* const kOctahedron =
    "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf "
    "2 3 6\nf "
    "4 2 6\nf 1 4 6\n";

}  // namespace

TEST_CASE("objects of every kind stand where their transform puts them") {
  const test::TemporaryFolder folder;
  test::write_nrrd(folder / "ball.nrrd", 49, -1.5, 1.5,
                   [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); });
  std::ofstream(folder / "oct.obj") << kOctahedron;
  const std::string place =
      R"(, "transform": {"scale": [2, 1, 1], "rotate": [0, 0, 1, 90], "translate": [10, 0, 0]}})";
  const std::string kinds[] = {std::string("{").append(kBall),
                               R"({"type": "volume", "file": "ball.nrrd", "iso": 1)",
                               R"({"type": "mesh", "file": "oct.obj")"};
  for (const std::string& kind : kinds) {
    CAPTURE(kind);
    const BuiltScene scene = built(kind + place, folder.path);
    // the long axis points along y now
    CHECK(first_hit(scene.scene, {10, -5, 0}, {0, 1, 0}).t == Approx(3).margin(1e-3));
    CHECK(first_hit(scene.scene, {5, 0, 0}, {2, 0, 0}).t == Approx(2).margin(1e-3));
    CHECK(first_hit(scene.scene, {10, 0, 7}, {0, 0, -1}).t == Approx(6).margin(1e-3));
    CHECK(first_hit(scene.scene, {0, -5, 0}, {0, 1, 0}).t == Box::inf);
  }
}

TEST_CASE("what is hidden is not there, but its instances are") {
  const std::string file = R"({"type": "mesh", "file": "is-not-there.ply", "visible": false}, )";
  const BuiltScene hidden =
      built(file + ball(R"(, "name": "b", "visible": false)") +
            R"(, {"type": "instance", "of": "b", "transforms": [{"translate": [9, 0, 0]}]})");
  CHECK(hidden.objects.size() == 3);
  CHECK(hidden.scene.objects.size() == 3);
  CHECK(first_hit(hidden.scene, {0, 0, 3}, {0, 0, -1}).t == Box::inf);
  CHECK(first_hit(hidden.scene, {9, 0, 3}, {0, 0, -1}).t == Approx(2));
  CHECK(hidden.scene.bounds().lo[0] == 7.5);
  // a scene of nothing is a picture of the background
  const BuiltScene nothing = built(ball(R"(, "visible": false)"));
  Film film(8, 8, {});
  render(nothing.scene, test::looking(nothing.scene, {0, 0, 3}, {0, 0, 0}, 8), {}, film);
  const float* const middle = film.color(36);
  CHECK(std::vector(middle, middle + 4) == std::vector<float>{1, 1, 1, 0});
}

TEST_CASE("the method of a formula does not depend on the iso-values before") {
  // far from its pole, and close to it
  const std::string pole = R"json({"type": "formula", "expr": "1/(x^2+y^2+z^2)", "iso": )json";
  BuiltScene moved = built(pole + "0.05}");
  const BuiltScene direct = built(pole + "[2, 4]}");
  const std::string before = moved.objects[0].method;
  moved.set_iso(0, {2, 4}, {});
  CHECK(moved.choose_method(0));
  CHECK(moved.objects[0].method == direct.objects[0].method);
  CHECK(moved.objects[0].method != before);
  CHECK(first_hit(moved.scene, {0, -3, 0.1}, {0, 1, 0}).t ==
        first_hit(direct.scene, {0, -3, 0.1}, {0, 1, 0}).t);
  moved.set_iso(0, {0.05}, {});
  CHECK(moved.choose_method(0));
  CHECK_FALSE(moved.choose_method(0));
  CHECK(moved.objects[0].method == before);
}

TEST_CASE("a mirrored mesh still knows its outside") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "oct.obj") << kOctahedron;
  const BuiltScene scene = built(
      R"({"type": "csg", "op": "difference", "of": [{"type": "mesh", "file": "oct.obj", "transform": {"scale": [1, 1, -1]}},
          {"type": "formula", "expr": "x^2+y^2+z^2-0.04"}]})",
      folder.path);
  CHECK(first_hit(scene.scene, {0, 0, 3}, {0, 0, -1}).t == Approx(2));
  CHECK(first_hit(scene.scene, {0, 0, 0}, {0, 0, -1}).t == Approx(0.2).margin(1e-4));
}

TEST_CASE("instances are copies of an object as it stands, with materials of their own in turn") {
  const BuiltScene scene =
      built(ball(R"(, "name": "a", "transform": {"scale": 0.5})") +
            R"(, {"type": "instance", "of": "a", "material": {"color": ["#ff0000", "#00ff00"]},
                 "transforms": [{"translate": [5, 0, 0]}, {"scale": 2, "translate": [0, 5, 0]}]})");
  REQUIRE(scene.scene.objects.size() == 3);
  REQUIRE(scene.objects.size() == 2);
  CHECK(scene.objects[1].count == 2);
  const test::OneHit first = first_hit(scene.scene, {5, -4, 0}, {0, 1, 0}),
                     second = first_hit(scene.scene, {-4, 5, 0}, {1, 0, 0}),
                     itself = first_hit(scene.scene, {0, 0, -4}, {0, 0, 1});
  CHECK(first.t == Approx(3.5));
  CHECK(first.object == 1);
  CHECK(second.t == Approx(3));
  CHECK(second.object == 2);
  CHECK(itself.t == Approx(3.5));
  CHECK(itself.object == 0);
  CHECK(scene.scene.objects[1].materials[0].color == Color{1, 0, 0});
  CHECK(scene.scene.objects[2].materials[0].color == Color{0, 1, 0});
  CHECK_THROWS_MATCHES(
      built(R"({"type": "instance", "of": "a", "transforms": [{}]}, )" + ball(R"(, "name": "a")")),
      InputError, says("before them"));
}

TEST_CASE("clip solids of a scene cut objects and their copies where they stand") {
  const auto scene_with = [](const std::string& clip, const std::string& copies) {
    const std::string text = R"({"isocast": 1)" + clip + R"(, "objects": [)" + ball(R"(, "name": "a")") +
                             R"(, {"type": "instance", "of": "a", "transforms": [{"translate": [5, 0, 0]}])" +
                             copies + "}]}";
    return build_scene(scene_from_text(text, "test", {}), {});
  };
  const auto first_t = [](const BuiltScene& scene, double x) {
    return first_hit(scene.scene, {x, 0, 4}, {0, 0, -1}).t;
  };
  const std::string below = R"([{"plane": [0, 0, 1, 0]}])", right = R"([{"plane": [-1, 0, 0, 5]}])";
  const BuiltScene whole = scene_with("", ""), cut = scene_with(R"(, "clip": )" + below, ""),
                   copies = scene_with("", R"(, "clip": )" + right),
                   both = scene_with(R"(, "clip": )" + below, R"(, "clip": )" + right);
  for (const double x : {0.0, 5.1}) {
    CHECK(first_t(whole, x) == Approx(3).margin(0.02));
    CHECK(first_t(cut, x) == Approx(5).margin(0.02));
  }
  CHECK(first_t(copies, 0) == Approx(3));
  CHECK(first_t(copies, 4.9) == Box::inf);
  CHECK(first_t(copies, 5.1) == Approx(3).margin(0.02));
  CHECK(first_t(both, 4.9) == Box::inf);
  CHECK(first_t(both, 5.1) == Approx(5).margin(0.02));
  const auto has = [](const std::vector<std::string>& words) {
    return std::ranges::find(words, "clip solids") != words.end();
  };
  CHECK(has(cut.features));
  CHECK_FALSE(has(cut.left_out));
  CHECK(has(whole.left_out));
  // what only its copies show stays hidden
  const std::string hidden =
      R"({"isocast": 1, "clip": )" + below + R"(, "objects": [)" +
      ball(R"(, "name": "a", "visible": false)") +
      R"(, {"type": "instance", "of": "a", "transforms": [{"translate": [5, 0, 0]}]}]})";
  const BuiltScene one = build_scene(scene_from_text(hidden, "test", {}), {});
  CHECK(first_t(one, 0) == Box::inf);
  CHECK(first_t(one, 5) == Approx(5));
  CHECK_THROWS_MATCHES(scene_with(R"(, "clip": [{"plane": [0, 0, 1, 0]}, {}])", ""), InputError,
                       says("clip[1]: found 0 of plane, box and formula"));
}

TEST_CASE("a hundred iso-values of one volume") {
  const test::TemporaryFolder folder;
  test::write_nrrd(folder / "ramp.nrrd", 17, 0, 1, [](double x, double, double) { return x; });
  std::string iso;
  for (int i = 0; i < 100; ++i) iso += (i ? ", " : "") + std::to_string((i + 0.5) / 100);
  BuiltScene scene =
      built(R"({"name": "ramp", "type": "volume", "file": "ramp.nrrd", "iso": [)" + iso + "]}", folder.path);
  REQUIRE(scene.scene.objects.size() == 7);
  CHECK(scene.objects.size() == 1);
  CHECK(scene.objects[0].iso.size() == 100);
  CHECK(scene.objects[0].mask_use().bricks == 100);
  std::size_t materials = 0;
  for (const SceneObject& object : scene.scene.objects) materials += object.materials.size();
  CHECK(materials == 100);
  for (const double from : {0.0, 0.317, 0.8})
    CHECK(first_hit(scene.scene, {from, 0.5, 0.5}, {1, 0, 0}).t ==
          Approx(std::ceil(from * 100 - 0.5) / 100 + 0.005 - from).margin(1e-5));
  std::vector<double> moved(100);
  for (std::size_t i = 0; i < 100; ++i) moved[i] = 0.9 + 0.001 * static_cast<double>(i);
  scene.set_iso(0, moved, {});
  CHECK(first_hit(scene.scene, {0, 0.5, 0.5}, {1, 0, 0}).t == Approx(0.9).margin(1e-5));
  CHECK_THROWS_MATCHES(scene.set_iso(0, {0.5}, {}), InputError, says("expected about as many as before"));
}

TEST_CASE("operands keep their materials, unless the whole has some") {
  const std::string parts =
      R"("type": "csg", "op": "difference", "of": [{"type": "formula", "expr": "max(abs(x),max(abs(y),abs(z)))-0.5", "material": {"color": "#ff0000"}},
         {"type": "formula", "expr": "x^2+y^2+z^2-0.36", "material": {"color": "#0000ff"}}])";
  const BuiltScene own = built(record(parts)),
                   one = built(record(parts + R"(, "material": {"color": "#00ff00"})"));
  const auto color_at = [](const BuiltScene& scene, const Double3& from, const Double3& at) {
    const View view = test::looking(scene.scene, from, at, 1);
    Film film(1, 1, {Layer::position});
    (void)render(scene.scene, view, {}, film);
    const float* const pixel = film.color(0);
    return Color{pixel[0], pixel[1], pixel[2]};
  };
  // through the round hole of a face: the inside of the ball, blue; at a corner: the cube, red
  const Color hole = color_at(own, {-1.4, -1.4, 4}, {0.4, 0.4, -0.2}),
              corner = color_at(own, {4, 4.1, 3.9}, {0, 0, 0});
  CHECK(hole[2] > hole[0]);
  CHECK(corner[0] > corner[2]);
  const Color green = color_at(one, {4, 4.1, 3.9}, {0, 0, 0});
  CHECK(green[1] > green[0]);
}

TEST_CASE("a hit is proved only behind objects that prove what is before it") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "oct.obj") << kOctahedron;
  const auto certificate = [&](const std::string& more) {
    const BuiltScene scene = built(ball(R"(, "method": "certified")") + more, folder.path);
    const View view = test::looking(scene.scene, {0.3, 0.2, 20}, {0, 0, 0}, 1);
    Film film(1, 1, {Layer::certificate});
    (void)render(scene.scene, view, {}, film);
    return *film.at(Layer::certificate, 0);
  };
  CHECK(certificate("") == 1);
  CHECK(certificate(R"(, {"type": "mesh", "file": "oct.obj", "transform": {"translate": [0, 0, -9]}})") == 1);
  // beside the ray, but its box is on the way
  CHECK(certificate(R"(, {"type": "mesh", "file": "oct.obj", "transform": {"translate": [0.8, 0.8, 5]}})") ==
        -1);
}

TEST_CASE("what cannot be built is told") {
  CHECK_THROWS_MATCHES(built(R"({"type": "mesh", "file": "none.ply"})"), InputError, says("none.ply"));
  CHECK_THROWS_MATCHES(built(ball(R"(, "method": "marmitt")")), InputError, says("marmitt"));
  CHECK_THROWS_MATCHES(built(ball(R"(, "set": {"epss": 1})")), InputError, says("epss"));
  const auto united = [](const std::string& more) {
    return record(std::string(R"("type": "csg", "op": "union", "of": [)")
                      .append(ball(more))
                      .append(", ")
                      .append(ball(""))
                      .append("]"));
  };
  CHECK_THROWS_MATCHES(built(united(R"(, "clip": [{"plane": [1, 0, 0, 0]}])")), InputError,
                       says("in an operand"));
  CHECK_THROWS_MATCHES(built(united(R"(, "color_by": {"expr": "x"})")), InputError, says("in an operand"));
  CHECK_THROWS_MATCHES(built(united(R"(, "color_components": true)")), InputError, says("in an operand"));
}
