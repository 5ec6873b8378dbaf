// Animations and clip planes of scenes in the viewer: what is cut or moved is not built again.
#include <isocast/apps/viewer/command_line.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "edited_scene.h"

using namespace isocast;
using namespace isocast::viewer;
using namespace isocast::test;

TEST_CASE("clip planes cut copies, too, and build nothing") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "two.json") << R"({"isocast": 1, "clip": [{"plane": [0, 0, 1, -0.5]}], "objects": [
    {"name": "ball", "type": "formula", "expr": "x^2+y^2+z^2-0.2", "transform": {"translate": [-0.5, 0, 0]}},
    {"type": "instance", "of": "ball", "transforms": [{"translate": [1, 0, 0]}]}]})";
  Session session = session_of(folder / "two.json");
  SceneKeeper keeper;
  const std::vector<float> whole = kept(keeper, shown(session));
  adopt(session, keeper);
  const std::vector<float> cut = kept(keeper, shown(session, {"x-0.5"}));
  CHECK((cut == rendered(shown(session, {"x-0.5"}))));
  // to the left of the plane's place all is as it was, to the right of it nothing
  const auto side = [](const std::vector<float>& picture, int from, int to) {
    std::vector<float> part;
    for (int y = 0; y < kSize; ++y)
      part.insert(part.end(), picture.begin() + 4 * (y * kSize + from),
                  picture.begin() + 4 * (y * kSize + to));
    return part;
  };
  CHECK((cut != whole));
  CHECK((side(cut, 0, kSize / 2) == side(whole, 0, kSize / 2)));
  CHECK((kept(keeper, shown(session)) == whole));
  CHECK(keeper.scene() == 1);
  const SceneJson written = document_of(write_scene(session, shown(session, {"x-0.5"}), folder / "out.png"));
  CHECK(written["clip"].size() == 2);
  CHECK_FALSE(written["objects"][0].contains("clip"));
}

TEST_CASE(
    "frames of an animation: only what changes is built again, and what is edited is no longer animated") {
  const test::TemporaryFolder folder;
  write_ball(folder / "ball.nrrd");
  const auto write = [&](const char* name, const char* key) {
    std::ofstream(folder / name)
        << R"({"isocast": 1, "cameras": {"a": {"position": [0, -9, 0]}, "b": {"position": [9, 0, 0]}},
    "objects": [{"name": "ball", "type": "volume", "file": "ball.nrrd", "iso": 0.4},
                {"name": "rod", "type": "formula", "expr": "x^2+y^2-r", "params": {"r": 0.01}}],
    "animation": {"frames": [3, 13], "keys": [{"frame": 3, "camera": "a", "iso": {"ball": 0.4}, "params": {}},
      {"frame": 13, "camera": "b", "iso": {"ball": 0.8}, "params": {)"
        << key << "}}]}}";
    return session_of(folder / name);
  };
  Session session = write("moved.json", "");
  REQUIRE(session.frames() == std::array{3, 13});
  SceneKeeper keeper;
  keeper.show(shown(session));
  adopt(session, keeper);
  CHECK(session.objects[0].surfaces.front().value == 0.4);
  session.frame = 8;
  CHECK(command_line(shown(session), "out.png").find("--frames 8:8") != std::string::npos);
  CHECK((kept(keeper, shown(session)) == rendered(shown(session))));
  CHECK(keeper.news().objects[0].iso.front() == Approx(0.6));
  CHECK((*keeper.news().camera.position)[0] == Approx(4.5));
  CHECK(keeper.scene() == 1);
  // a slider wins over the animation
  session.objects[0].surfaces.front().value = 0.3;
  keeper.show(shown(session));
  CHECK(keeper.news().objects[0].iso.front() == 0.3);
  CHECK(keeper.scene() == 1);

  Session other = write("changed.json", R"("rod.r": 0.5)");
  keeper.show(shown(other));
  const int scenes = keeper.scene();
  other.frame = 13;
  CHECK((kept(keeper, shown(other)) == rendered(shown(other))));
  CHECK(keeper.scene() == scenes + 1);
  CHECK_FALSE(session_of("@tangle").frames());
}

TEST_CASE("numbered volumes are frames") {
  const test::TemporaryFolder folder;
  for (const char* name : {"ball_02.nrrd", "ball_03.nrrd", "ball_11.nrrd", "ball_111.nrrd", "ball_x.nrrd"})
    write_ball(folder / name);
  write_nrrd(folder / "ball_03.nrrd", 16, -1, 1, [](double x, double, double) { return x; });
  Session session = session_of(folder / "ball_%02d.nrrd");
  CHECK(session.frames() == std::array{2, 111});
  CHECK(session.frame == 2);
  SceneKeeper keeper;
  const std::vector<float> ball = kept(keeper, shown(session));
  CHECK((ball == kept(keeper, shown(session_of(folder / "ball_02.nrrd")))));
  session.frame = 3;
  const std::vector<float> half = kept(keeper, shown(session));
  CHECK((half == kept(keeper, shown(session_of(folder / "ball_03.nrrd")))));
  CHECK((half != ball));
  CHECK(command_line(shown(session), "out.png").find("--frames 3:3") != std::string::npos);
  CHECK_FALSE(session_of(folder / "other_%02d.nrrd").frames());
}
