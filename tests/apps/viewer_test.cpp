// The viewer without its window: what its pictures, its loop and its choices are held to.
#include <isocast/apps/viewer/camera_motion.h>
#include <isocast/apps/viewer/clip_planes.h>
#include <isocast/apps/viewer/command_line.h>
#include <isocast/apps/viewer/formula_names.h>
#include <isocast/apps/viewer/iso_choices.h>
#include <isocast/apps/viewer/script/script.h>
#include <isocast/apps/viewer/session.h>

#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;
using namespace isocast::viewer;

namespace {

Camera example() {
  Camera camera;
  camera.position = {1, -4, 2};
  camera.target = {0.5, 0, 0};
  camera.up = {0, 0, 1};
  return camera;
}
RenderWords words_for(const std::string& input) {
  RenderWords words;
  words.input = input;
  return words;
}

// Where a point of the world is seen, in heights of the picture from its middle.
std::array<double, 2> seen_at(const Camera& camera, const Double3& p) {
  const Double3 forward = normalized(camera.target - camera.position),
                right = normalized(cross(forward, camera.up)), down = cross(forward, right);
  const Double3 arm = p - camera.position;
  const double height =
      height_at_target(camera) *
      (camera.ortho_height ? 1 : dot(arm, forward) / length(camera.target - camera.position));
  return {dot(arm, right) / height, dot(arm, down) / height};
}

}  // namespace

TEST_CASE("orbit keeps the distance and stays off the poles") {
  const Camera camera = example();
  const double distance = length(camera.position - camera.target);
  const Camera turned = orbit(camera, 0.25, 0);
  CHECK(length(turned.position - turned.target) == Approx(distance));
  CHECK(turned.position[2] == Approx(camera.position[2]));
  const Double3 a = camera.position - camera.target, b = turned.position - turned.target;
  const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  CHECK(angle == Approx(-std::acos(-1.0) / 4));
  for (const double dy : {-10.0, 10.0}) {
    const Camera pole = orbit(camera, 0, dy);
    CHECK(length(pole.position - pole.target) == Approx(distance));
    CHECK((pole.position[2] - pole.target[2] < 0) == (dy < 0));
    CHECK_NOTHROW(frame(Box(), {pole.position, pole.target, pole.up, {}, {}}, 1));
  }
  const Camera back = orbit(turned, -0.25, 0);
  for (int i = 0; i < 3; ++i) CHECK(back.position[i] == Approx(camera.position[i]));
}

TEST_CASE("what lies at the target's depth follows a pan") {
  for (const bool perspective : {true, false}) {
    const Camera camera = with_perspective(example(), perspective);
    const auto place = seen_at(pan(camera, 0.2, -0.1), camera.target);
    CHECK(place[0] == Approx(0.2));
    CHECK(place[1] == Approx(-0.1));
  }
}

TEST_CASE("both kinds of camera show the target's depth alike, and zoom alike") {
  const Camera camera = example(), flat = with_perspective(camera, false);
  CHECK(height_at_target(flat) == Approx(height_at_target(camera)));
  CHECK(height_at_target(zoom(camera, 3)) == Approx(height_at_target(zoom(flat, 3))));
  CHECK(height_at_target(zoom(camera, 1)) == Approx(0.9 * height_at_target(camera)));
  const Camera again = with_perspective(zoom(flat, 2), true);
  CHECK_FALSE(again.ortho_height);
  CHECK(height_at_target(again) == Approx(height_at_target(zoom(camera, 2))));
}

TEST_CASE("fit and standard views") {
  Box box;
  box.add(Double3{-1, -2, -3});
  box.add(Double3{3, 2, 1});
  const Camera framed = frame(box, {}, 1.5), fitted = fit(example(), box, 1.5);
  CHECK(length(fitted.position - fitted.target) == Approx(length(framed.position - framed.target)));
  for (int i = 0; i < 3; ++i) CHECK(fitted.target[i] == box.center()[i]);
  for (const StandardView& view : standard_views()) CHECK_NOTHROW(View(look_from(example(), view), 16, 16));
}

TEST_CASE("a session starts as its command line says and says it again") {
  RenderWords words = words_for("x^2+y^2+z^2-1");
  words.iso = "0,0.5";
  words.colors = "#ff8000";
  words.opacity = "0.25,1";
  const Session session = start_session(words);
  REQUIRE(session.object().surfaces.size() == 2);
  CHECK(hex_of(session.object().surfaces[1].color) == "#ff8000");
  CHECK(words_of(session, 320, 200).colors == "#ff8000");
  Session changed = session;
  changed.object().adopted.clear();
  const RenderWords again = words_of(changed, 320, 200);
  CHECK(again.iso == "0,0.5");
  CHECK(again.colors == "#ff8000,#ff8000");
  CHECK(again.opacity == "0.25,1");
  CHECK(again.size == "320x200");
  CHECK(again.position.empty());
  CHECK(
      command_line(again, "out.png") ==
      "isocast render 'x^2+y^2+z^2-1' --iso 0,0.5 --colors '#ff8000,#ff8000' --opacity 0.25,1 --size 320x200 "
      "-o out.png");
}

TEST_CASE("hidden surfaces are not in the picture") {
  Session session = start_session(words_for("@tangle"));
  CHECK(words_of(session, 10, 10).iso.empty());
  adopt_surfaces(session.object(), {0, 1}, {{}, {}});
  add_surface(session.object(), 0.1);
  session.object().surfaces[1].visible = false;
  CHECK(words_of(session, 10, 10).iso == "0,0.1");
  for (IsoSurface& surface : session.object().surfaces) surface.visible = false;
  const RenderWords nothing = words_of(session, 10, 10);
  CHECK(nothing.iso == "0");
  CHECK(nothing.opacity == "0");
}

TEST_CASE("a moved camera is written so that the same numbers are read") {
  Session session = start_session(words_for("x+y+z"));
  session.camera = orbit(example(), 0.123, 0.0456);
  CameraWishes read;
  change_camera(words_of(session, 10, 10), read);
  CHECK(*read.position == session.camera->position);
  CHECK(*read.target == session.camera->target);
  CHECK(*read.fov == session.camera->fov);
}

TEST_CASE("words that a shell would change are quoted") {
  RenderWords words = words_for(" -x^2+y");
  words.params = {"a=2"};
  words.clips = {"x-0.5", "it's"};
  CHECK(command_line(words, "a b.png") ==
        "isocast render '-x^2+y' --param a=2 --clip x-0.5 --clip 'it'\\''s' -o 'a b.png'");
}

TEST_CASE("scripts are read, and their mistakes named") {
  const auto commands = parse_script("wait  # for it\n\n  formula \"x^2 + #y\"\nparam a -2.5e-1\n", "s.txt");
  REQUIRE(commands.size() == 3);
  CHECK(commands[1].words == std::vector<std::string>{"x^2 + #y"});
  CHECK(commands[2].line == 4);
  CHECK(commands[2].words == std::vector<std::string>{"a", "-2.5e-1"});
  CHECK_THROWS_WITH(parse_script("wait\niso\n", "s.txt"), "s.txt:2: found 'iso', expected iso NUMBER");
  CHECK_THROWS_WITH(parse_script("click 1 b", "s.txt"), Catch::StartsWith("s.txt:1: found 'click 1 b'"));
  CHECK_THROWS_WITH(parse_script("quit now", "s.txt"), Catch::Contains("expected quit"));
  CHECK_THROWS_WITH(parse_script("jump", "s.txt"), Catch::Contains("expected one of wait, iso"));
}

TEST_CASE("clip planes are formulas that keep their side") {
  Box box;
  box.add(Double3{-2, 0, 0});
  box.add(Double3{2, 4, 1});
  const auto formulas =
      clip_formulas({{0, 0.25, false, true}, {1, 0.5, true, true}, {2, 0.5, true, false}}, box);
  CHECK(formulas == std::vector<std::string>{"x-(-1)", "(2)-y"});
  CHECK(clip_formulas({{}}, Box()).empty());
}

TEST_CASE("parameters of words and of the catalogue") {
  RenderWords words = words_for("@barth_sextic");
  words.params = {"b=3"};
  const auto numbers = parameters_of(words);
  CHECK(numbers.back().name == "b");
  CHECK(numbers.back().value == 3);
  CHECK(uses_time(start_session(words_for("x+sin(w)"))));
  CHECK_FALSE(uses_time(start_session(words_for("x+wave*0.5"))));
  Session scene;
  const auto with = [&](const char* object) {
    scene.document = SceneJson::parse(std::string(R"({"objects": [{"name": "w", "type": "csg", "of": [)") +
                                      object + "]}]}");
    return uses_time(scene);
  };
  CHECK(with(R"({"expr": "x+w"})"));
  CHECK(with(R"({"expr": "x", "clip": [{"formula": "w-x"}]})"));
  CHECK_FALSE(with(R"({"expr": "wave"}, {"file": "w"})"));
}

TEST_CASE("iso-values by the share that they enclose") {
  Histogram histogram;
  histogram.lo = 0;
  histogram.hi = 256;
  for (std::int64_t& count : histogram.counts) count = 10;
  CHECK(enclosing_iso(histogram, 25) == Approx(192));
  CHECK(enclosing_iso(histogram, 0) == Approx(256));
  CHECK(enclosing_iso(histogram, 100) == Approx(0));
  CHECK(enclosing_iso(histogram, 1000) == Approx(0));
}
