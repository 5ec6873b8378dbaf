// Scenes at their frames.
#include <input_error.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/apps/scene_build/scene_file.h>

#include <catch2/catch.hpp>

#include "../implicit/expression/evaluate_text.h"

using namespace isocast;
using test::says;

namespace {

SceneDescription animated(const std::string& keys) {
  return scene_from_text(R"({"isocast": 1,
    "cameras": {"a": {"position": [0, 0, 0], "fov": 20}, "b": {"position": [10, 20, 30], "fov": 60}},
    "objects": [
      {"name": "ball", "type": "formula", "expr": "x*r+w", "params": {"r": 1}, "iso": [1, 2]},
      {"name": "still", "type": "formula", "expr": "w", "time": 5},
      {"name": "ct", "type": "volume", "file": "ct_%04d.nrrd"}],
    "animation": {"frames": [0, 10], "keys": [)" +
                             keys + "]}}",
                         "s.json", "/data");
}

const FormulaSource& ball(const SceneDescription& scene) {
  return std::get<FormulaSource>(scene.objects[0].source);
}

}  // namespace

TEST_CASE("what keys name is interpolated between those that name it") {
  const SceneDescription scene = animated(R"(
    {"frame": 2, "time": 1, "camera": "a", "params": {"ball.r": 10}, "iso": {"ball": [1, 2]}},
    {"frame": 4, "time": 7},
    {"frame": 6, "camera": "b", "params": {"ball.r": 30}, "iso": {"ball": [3, 6]}})");
  CHECK(frames_of(scene) == std::array{0, 10});
  for (const int frame : {0, 2}) {
    const SceneDescription at = description_at(scene, frame);
    CHECK(at.time == 1);
    CHECK(ball(at).time == 1);
    CHECK(*at.camera.position == Double3{0, 0, 0});
    CHECK(at.objects[0].iso == std::vector<double>{1, 2});
    CHECK(ball(at).parameters.back().value.value == 10);
  }
  const SceneDescription middle = description_at(scene, 4);
  CHECK(middle.time == 7);
  CHECK(*middle.camera.position == Double3{5, 10, 15});
  CHECK(*middle.camera.fov == 40);
  CHECK(middle.objects[0].iso == std::vector<double>{2, 4});
  CHECK(ball(middle).parameters.back().value.value == 20);
  CHECK(std::get<FormulaSource>(middle.objects[1].source).time == 5);
  CHECK(description_at(scene, 3).time == 4);
  const SceneDescription end = description_at(scene, 9);
  CHECK(end.time == 7);
  CHECK(*end.camera.position == Double3{10, 20, 30});
  CHECK(ball(end).parameters.back().value.value == 30);
  // the scene itself is as it was
  CHECK(scene.time == 0);
}

TEST_CASE("operands are animated like objects") {
  const SceneDescription scene = scene_from_text(R"({"isocast": 1, "objects": [
      {"name": "all", "type": "csg", "op": "union", "of": [
        {"type": "csg", "op": "difference", "of": [
          {"name": "deep", "type": "formula", "expr": "x*r+w", "params": {"r": 1}},
          {"name": "fixed", "type": "formula", "expr": "w+r", "params": {"r": 2}, "time": 5}]},
        {"name": "ct", "type": "volume", "file": "ct_%d.nrrd", "iso": 4}]}],
    "animation": {"frames": [0, 4], "keys": [
      {"frame": 0, "time": 1, "params": {"deep.r": 10}, "iso": {"ct": 10, "deep": [1, 2]}},
      {"frame": 4, "time": 3, "params": {"deep.r": 30}, "iso": {"ct": 30, "deep": [3, 6]}}]}})",
                                                 "s.json", "/data");
  const SceneDescription at = description_at(scene, 2);
  const auto& parts = std::get<CsgSource>(at.objects[0].source).of;
  const auto& nested = std::get<CsgSource>(parts[0].source).of;
  const auto& deep = std::get<FormulaSource>(nested[0].source);
  CHECK(deep.time == 2);
  CHECK(nested[0].iso == std::vector<double>{2, 4});
  // the formula itself has the new parameter
  CHECK(test::run(make_tape(deep.expression), {1, 0, 0, 2}) == 22);
  CHECK(std::get<FormulaSource>(nested[1].source).time == 5);
  CHECK(parts[1].iso == std::vector<double>{20});
  CHECK(std::get<VolumeSource>(parts[1].source).file == "/data/ct_2.nrrd");
}

TEST_CASE("file sequences take the frame's number") {
  const SceneDescription scene = animated("");
  CHECK(std::get<VolumeSource>(description_at(scene, 7).objects[2].source).file == "/data/ct_0007.nrrd");
  CHECK(numbered_file("a%d.raw", 12) == "a12.raw");
  CHECK(numbered_file("f/a%03d_b.raw", 12345) == "f/a12345_b.raw");
  CHECK(numbered_file("plain.raw", 3) == "plain.raw");
  for (const char* const name : {"%s.raw", "a%", "%d%d.raw", "%n.raw", "%99d.raw", "%-3d.raw", "%04x.raw"})
    CHECK_THROWS_MATCHES(numbered_file(name, 1), InputError, says("found a %"));
}

TEST_CASE("what cannot be animated is told") {
  CHECK_THROWS_MATCHES(description_at(animated(R"({"frame": 0, "params": {"ball.q": 1}})"), 0), InputError,
                       says("'ball.q'"));
  CHECK_THROWS_MATCHES(description_at(animated(R"({"frame": 0, "params": {"ct.q": 1}})"), 0), InputError,
                       says("'ct.q'"));
  CHECK_THROWS_MATCHES(
      description_at(animated(R"({"frame": 0, "iso": {"ball": 1}}, {"frame": 2, "iso": {"ball": [1, 2]}})"),
                     1),
      InputError, says("found 1 and 2 iso-values"));
  const auto with_operands = [](const std::string& names) {
    return scene_from_text(R"({"isocast": 1, "objects": [{"name": "a", "type": "csg", "op": "union", "of": [
      {"name": ")" + names + R"(", "type": "mesh", "file": "a.ply"}, {"type": "mesh", "file": "b.ply"}]}],
      "animation": {"frames": [0, 1], "keys": [{"frame": 0, "iso": {"a": 1}}]}})",
                           "s.json", "/data");
  };
  CHECK_THROWS_MATCHES(with_operands("a"), InputError, says("two objects have the name 'a'"));
  CHECK_THROWS_MATCHES(description_at(with_operands("b"), 0), InputError, says("iso-values of 'a'"));
}
