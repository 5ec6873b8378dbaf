// Scenes that the viewer edits: what it shows, what it builds again, and the file that it writes.
#include <input_error.h>
#include <isocast/apps/viewer/command_line.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "edited_scene.h"

using namespace isocast;
using namespace isocast::viewer;
using namespace test;

namespace {

// A volume, a formula and a mesh of one triangle in a folder, and a scene of them.
std::string write_scene_of_three(const std::filesystem::path& folder) {
  write_ball(folder / "ball.nrrd");
  std::ofstream(folder / "one.obj") << "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nf 1 2 3\n";
  std::ofstream(folder / "three.json") << R"({"isocast": 1, // three kinds
    "lights": [{"type": "directional", "direction": [1, -2, 3]}], "objects": [
    {"name": "ball", "type": "volume", "file": "ball.nrrd", "iso": 0.4},
    {"name": "rod", "type": "formula", "expr": "x^2+y^2-r", "params": {"r": 0.01}, "material": {"specular": 0.4}},
    {"name": "sheet", "type": "mesh", "file": "one.obj"}]})";
  return folder / "three.json";
}

}  // namespace

TEST_CASE("a scene file is shown as it is, and its own name is copied") {
  const test::TemporaryFolder folder;
  const std::string file = write_scene_of_three(folder.path);
  Session session = session_of(file);
  REQUIRE(session.objects.size() == 3);
  CHECK(session.objects[0].name == "ball");
  CHECK(session.objects[1].type == "formula");
  CHECK_FALSE(session.objects[2].has_iso());
  SceneKeeper keeper;
  RenderWords plain;
  plain.input = file;
  CHECK((kept(keeper, shown(session)) == rendered(plain)));
  adopt(session, keeper);
  CHECK(session.objects[0].surfaces.front().value == 0.4);
  CHECK(session.objects[2].surfaces.size() == 1);
  const RenderWords words = write_scene(session, shown(session), folder / "out.png");
  CHECK(words.input == file);
  CHECK(words.scene_text.empty());
  CHECK_FALSE(std::filesystem::exists(folder / "out.scene.json"));
}

TEST_CASE(
    "objects of a scene are edited without building it again, and the file that is written shows the same") {
  const test::TemporaryFolder folder, other;
  Session session = session_of(write_scene_of_three(folder.path));
  SceneKeeper keeper;
  const std::vector<float> before = kept(keeper, shown(session));
  adopt(session, keeper);
  session.objects[0].surfaces.front() = {0.8, {1, 0, 0}, 0.5, 0.25, true};
  session.objects[0].method = "certified";
  session.objects[1].surfaces.front().value = 0.05;
  add_surface(session.objects[1], 0.1);
  const RenderWords words = shown(session);
  const std::vector<float> edited = kept(keeper, words);
  CHECK(keeper.scene() == 1);
  CHECK(keeper.news().objects[0].method == "certified");
  CHECK((edited != before));
  CHECK((edited == rendered(words)));

  // a file elsewhere, with the same picture
  const RenderWords written = write_scene(session, words, other / "out.png");
  CHECK(written.input == other / "out.scene.json");
  CHECK(command_line(written, "out.png").starts_with("isocast render " + written.input));
  CHECK((rendered(written) == edited));
  const SceneJson object = document_of(written)["objects"][1];
  CHECK(object["material"]["specular"] == 0.4);  // what was not edited stays
  CHECK(object["iso"] == SceneJson{0.05, 0.1});

  // and back again
  session.objects[1].surfaces.pop_back();
  session.objects[1].surfaces.front().value = 0;
  session.objects[0].surfaces = session.objects[0].adopted;
  session.objects[0].method = "auto";
  CHECK((kept(keeper, shown(session)) == before));
  CHECK(keeper.scene() == 1);
}

TEST_CASE("volumes that stay are not loaded again: hidden objects, other methods of formulas, clip planes") {
  const test::TemporaryFolder folder;
  Session session = session_of(write_scene_of_three(folder.path));
  SceneKeeper keeper;
  const std::vector<float> before = kept(keeper, shown(session));
  adopt(session, keeper);
  std::filesystem::remove(folder / "ball.nrrd");
  const std::vector<float> cut = kept(keeper, shown(session, {"x"}));
  CHECK((cut != before));
  CHECK(keeper.scene() == 1);
  CHECK((kept(keeper, shown(session)) == before));

  session.objects[1].method = "interval";
  CHECK_NOTHROW(keeper.show(shown(session)));
  CHECK(keeper.scene() == 2);
  session.objects[1].method = "auto";
  session.objects[1].visible = false;
  session.objects[2].visible = false;
  const std::vector<float> ball = kept(keeper, shown(session));
  CHECK((ball != before));
  CHECK(keeper.news().objects.size() == 3);
  session.objects[0].visible = false;
  CHECK(kept(keeper, shown(session)) != ball);  // nothing
  // now the volume was dropped
  session.objects[0].visible = true;
  CHECK_THROWS_MATCHES(keeper.show(shown(session)), InputError, says("ball.nrrd"));
}

TEST_CASE("clip planes of a single volume build nothing") {
  const test::TemporaryFolder folder;
  write_ball(folder / "ball.nrrd");
  Session session = session_of(folder / "ball.nrrd");
  SceneKeeper keeper;
  keeper.show(shown(session));
  std::filesystem::remove(folder / "ball.nrrd");
  const auto bounds = [&](const std::vector<std::string>& clips) {
    keeper.show(shown(session, clips));
    const View view(frame(Box{{-1, -1, -1}, {1, 1, 1}}, {}, 1), kSize, kSize);
    Film film(kSize, kSize, {});
    render(keeper.built().scene, view, {}, film);
    return film.color();
  };
  const std::vector<float> whole = bounds({}), half = bounds({"x"}), quarter = bounds({"x", "y"});
  CHECK((whole != half));
  CHECK((half != quarter));
  CHECK((bounds({}) == whole));
  CHECK(keeper.scene() == 1);
}

TEST_CASE("colours by another field: a scene file says what the command line cannot") {
  const test::TemporaryFolder folder;
  RenderWords words;
  words.input = "a*x^2+y^2+z^2-0.5";
  words.params = {"a=2"};
  words.domain = "-1,1,-2,2,-1,1";
  words.method = "interval";
  words.set = {"eps=0.001"};
  words.opacity = "0.5";
  words.clips = {"z-a/4"};
  words.lights = {"0,0,1"};
  Session session = start_session(words);
  CHECK(shown(session).scene_text.empty());
  const std::vector<float> plain = rendered(shown(session));

  // as a scene it looks the same
  RenderWords scene = words;
  scene.scene_text = text_of(document_of(words));
  scene.input = "scene.json";
  clear_object_words(scene);
  CHECK((rendered(scene) == plain));

  session.object().color_by = {"x+w", "grey", "-1,0.5", false};
  const RenderWords colored = write_scene(session, shown(session), folder / "out.png");
  CHECK((rendered(colored) != plain));
  CHECK(command_line(colored, "out.png") == "isocast render " + std::string(folder / "out.scene.json") +
                                                " --light 0,0,1 --size 40x40 -o out.png");
  const SceneJson colors = document_of(colored)["objects"][0]["color_by"];
  CHECK(colors == SceneJson{{"expr", "x+w"}, {"map", "grey"}, {"range", {-1.0, 0.5}}, {"log", false}});
  SceneKeeper keeper;
  CHECK((kept(keeper, shown(session)) == rendered(colored)));

  write_ball(folder / "ball.nrrd");
  session.object().color_by.of = folder / "ball.nrrd";
  session.object().color_by.range.clear();
  CHECK((kept(keeper, shown(session)) != rendered(colored)));
  session.object().color_by.range = "one";
  CHECK_THROWS_MATCHES(shown(session), InputError, says("range"));
  session.object().color_by.of.clear();
  CHECK((rendered(shown(session)) == plain));
}

TEST_CASE("every input is a scene") {
  const test::TemporaryFolder folder;
  const auto type_of = [](const std::string& input) { return session_of(input).object().type; };
  CHECK(type_of("x^2+y^2-1") == "formula");
  CHECK(type_of("@tangle") == "surface");
  CHECK(type_of("some/where.nrrd") == "volume");
  CHECK(type_of("some/mesh.ply") == "mesh");
  RenderWords words;
  words.input = "a/v.raw";
  words.read.dims = {2, 3, 4};
  words.read.type = SampleType::u16;
  words.read.big_endian = true;
  words.read.skip = 7;
  const SceneJson object = document_of(words)["objects"][0];
  CHECK(object["dims"] == SceneJson{2, 3, 4});
  CHECK(object["sample_type"] == "u16");
  CHECK(object["endian"] == "big");
  CHECK(object["skip"] == 7);
  CHECK(object["file"] == std::filesystem::absolute("a/v.raw").string());
  CHECK_THROWS_MATCHES(session_of(folder / "none.json"), InputError, says("none.json"));
}
