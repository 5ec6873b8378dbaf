// Scene files: what they say, and what is told of those that cannot be read.
#include <input_error.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/scene_build/scene_json.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;
using test::says;

namespace {

SceneDescription scene_of(const std::string& objects, const std::string& more = "") {
  return scene_from_text(R"({"isocast": 1, "objects": [)" + objects + "]" + more + "}", "s.json", "/data");
}

// A scene that cannot be read, with a part of the sentence.
void refuse(const std::string& text, const std::string& sentence) {
  CAPTURE(text);
  CHECK_THROWS_MATCHES(scene_from_text(text, "s.json", ""), InputError, says(sentence));
}
void refuse_object(const std::string& object, const std::string& sentence) {
  refuse(R"({"isocast": 1, "objects": [)" + object + "]}", sentence);
}

const char* const kScene = R"(
    // comments are allowed
    { "isocast": 1,
      "cameras": {"near": {"position": [1, 2, 3], "fov": 30}, "far": {"ortho": 5}}, /* these too */
      "lights": [{"type": "directional", "direction": [0, 0, 1]}, {"type": "ambient_occlusion", "samples": 32}],
      "shadows": true, "background": "#ffffff", "time": 2, "size": [64, 32], "spp": 4,
      "objects": [
        {"name": "head", "type": "volume", "file": "head.nii.gz", "iso": [40, 120], "method": "marmitt",
         "set": {"iterations": 5, "face": "on"},
         "material": {"color": [[0.9, 0.7, 0.6], [1, 1, 1]], "opacity": [0.4, 1], "reflectivity": 0.25, "specular": 0},
         "transform": {"translate": [1, 2, 3], "rotate": [0, 0, 1, 90], "scale": 2},
         "clip": [{"plane": [1, 0, 0, -4]}, {"box": [[0, 0, 0], [1, 1, 1]]}, {"formula": "x-a", "params": {"a": 3}}],
         "color_by": {"file": "pet.nii.gz", "map": "magma", "range": [0, 1]}},
        {"name": "knot", "type": "formula", "expr": "x+a", "domain": [[-2, 2], [-3, 3], [-4, 4]], "params": {"a": 2}},
        {"type": "surface", "id": "barth_decic", "time": 7},
        {"type": "mesh", "file": "/meshes/bunny.ply"},
        {"type": "csg", "op": "difference", "of": [{"type": "formula", "expr": "x"}, {"type": "formula", "expr": "y"}]},
        {"type": "instance", "of": "knot", "transforms": [{"translate": [1, 0, 0]}, {}]}]})";

}  // namespace

TEST_CASE("the keys of interface.md mean what they say") {
  const SceneDescription scene = scene_from_text(kScene, "s.json", "/data");
  REQUIRE(scene.objects.size() == 6);
  CHECK(scene.cameras.size() == 2);
  CHECK(scene.camera.ortho_height == 5);  // "far" comes first
  CHECK(scene.lights == std::vector<Double3>{{0, 0, 1}});
  CHECK(scene.ambient_occlusion.samples == 32);
  CHECK(scene.shadows);
  CHECK(scene.background == Color{1, 1, 1});
  CHECK(scene.wishes.size == std::array{64, 32});
  CHECK(scene.wishes.spp == 4);

  const ObjectDescription& head = scene.objects[0];
  CHECK(std::get<VolumeSource>(head.source).file == "/data/head.nii.gz");
  CHECK(head.iso == std::vector<double>{40, 120});
  CHECK(head.settings == std::map<std::string, std::string>{{"iterations", "5"}, {"face", "on"}});
  CHECK(head.materials.colors.size() == 2);
  CHECK(head.materials.opacities == std::vector<double>{0.4, 1});
  CHECK(head.materials.reflectivities == std::vector<double>{0.25});
  CHECK(material_of(head.materials, 1).specular == 0);
  CHECK(head.clips.size() == 3);
  CHECK(std::get<VolumeSource>(head.color_by->field).file == "/data/pet.nii.gz");
  // scaled, turned, shifted: x becomes y
  CHECK(head.place.point({1, 0, 0}) == Double3{1, 4, 3});

  const auto& knot = std::get<FormulaSource>(scene.objects[1].source);
  CHECK(knot.time == 2);
  CHECK(knot.domain.lo == std::array<double, 3>{-2, -3, -4});
  CHECK(std::get<FormulaSource>(scene.objects[2].source).time == 7);
  CHECK(std::get<MeshSource>(scene.objects[3].source).file == "/meshes/bunny.ply");
  CHECK(std::get<CsgSource>(scene.objects[4].source).operation == CsgOperation::subtract);
  CHECK(std::get<InstanceSource>(scene.objects[5].source).places.size() == 2);
}

TEST_CASE("one colour is no list of colours") {
  const std::string ball = R"({"type": "formula", "expr": "x", "material": {"color": )";
  CHECK(scene_of(ball + "[1, 0, 0]}}").objects[0].materials.colors == std::vector<Color>{{1, 0, 0}});
  CHECK(scene_of(ball + R"("#ff0000"}})").objects[0].materials.colors == std::vector<Color>{{1, 0, 0}});
  CHECK(scene_of(ball + R"(["#ff0000", [0, 1, 0]]}})").objects[0].materials.colors ==
        std::vector<Color>{{1, 0, 0}, {0, 1, 0}});
  refuse_object(ball + "[1, 0]}}", "s.json: objects[0].material.color");
  refuse_object(ball + R"([1, "#ff0000", 0]}})", "s.json: objects[0].material.color");
  refuse_object(ball + R"("red"}})", "found 'red', expected a colour");
}

TEST_CASE("keys that are unknown, missing, mistyped or there twice are told with their path") {
  refuse_object(R"({"type": "formula", "expr": "x", "materiel": {}})",
                "s.json: objects[0].materiel: found an unknown key");
  refuse_object(R"({"type": "formula", "expr": "x", "materiel": {}})", "did you mean 'material'?");
  refuse_object(R"({"type": "formula"})", "s.json: objects[0]: the key 'expr' is missing");
  refuse_object(R"({"type": "formla", "expr": "x"})", "did you mean 'formula'?");
  refuse_object(R"({"expr": "x"})", "the key 'type' is missing");
  refuse_object(R"({"type": "formula", "expr": 3})", "s.json: objects[0].expr: found 3, expected a text");
  refuse_object(R"({"type": "formula", "expr": "x", "iso": ["1"]})", "objects[0].iso[0]: found '1'");
  refuse_object(R"({"type": "formula", "expr": "x", "expr": "y"})", "the key 'expr' is there twice");
  refuse_object(R"({"type": "formula", "expr": "x+"})", "s.json: objects[0].expr: formula:1:3:");
  refuse_object(
      R"({"type": "csg", "op": "minus", "of": [{"type": "formula", "expr": "x"}, {"type": "formula", "expr": "y"}]})",
      "found 'minus', expected one of: union");
  refuse_object(
      R"({"type": "csg", "op": "union", "of": [{"type": "formula", "expr": "x"}, {"type": "mesh", "fil": ""}]})",
      "s.json: objects[0].of[1].fil");
  refuse_object(R"({"type": "formula", "expr": "x", "domain": [[1, -1], [0, 1], [0, 1]]})",
                "objects[0].domain[0]");
  refuse(R"({"isocast": 2, "objects": []})", "s.json: isocast: found 2");
  refuse(R"({"isocast": 1, "objects": []})", "s.json: objects: found a list of 0");
  refuse(R"({"objects": [{"type": "formula", "expr": "x"}]})", "the key 'isocast' is missing");
  refuse("[]", "s.json: the scene: found a list of 0");
}

TEST_CASE("numbers out of range, names of nothing and impossible combinations are told") {
  const auto with = [](const std::string& more) {
    return R"({"isocast": 1, "objects": [{"name": "a", "type": "formula", "expr": "x"}], )" + more + "}";
  };
  refuse(with(R"("camera": {"fov": 180})"), "s.json: camera.fov: found 180");
  refuse(with(R"("camera": {"fov": 45, "ortho": 3})"), "found fov and ortho");
  refuse(with(R"("camera": {}, "cameras": {})"), "found camera and cameras");
  refuse(with(R"("time": 1e999)"), "beyond the range");
  refuse(with(R"("spp": 0.5)"), "s.json: spp: found 0.5");
  refuse(with(R"("size": [64, 0])"), "s.json: size[1]");
  refuse(with(R"("lights": [{"type": "directional", "direction": [0, 0, 0]}])"), "lights[0].direction");
  refuse(with(R"("animation": {"frames": [3, 1]})"), "animation.frames");
  refuse(with(R"("animation": {"frames": [0, 9], "keys": [{"frame": 3}, {"frame": 3}]})"),
         "animation.keys[1].frame");
  refuse(with(R"("animation": {"frames": [0, 9], "keys": [{"frame": 3, "camera": "b"}]})"),
         "s.json: animation.keys[0].camera: no camera has the name 'b'");
  refuse(with(R"("animation": {"frames": [0, 9], "keys": [{"frame": 3, "iso": {"b": 1}}]})"),
         "did you mean 'a'?");
  refuse_object(R"({"type": "instance", "of": "a", "transforms": [{}]})", "no object has the name 'a'");
  refuse_object(
      R"({"name": "a", "type": "formula", "expr": "x"}, {"name": "a", "type": "formula", "expr": "x"})",
      "two objects have the name 'a'");
  refuse_object(R"({"type": "formula", "expr": "x", "transform": {"scale": 0}})",
                "objects[0].transform: the transform has no inverse");
  refuse_object(R"({"type": "formula", "expr": "x", "transform": {"scale": [1, 1, 1e-320]}})", "no inverse");
  refuse_object(R"({"type": "formula", "expr": "x", "transform": {"rotate": [0, 0, 0, 9]}})",
                "without an axis");
  refuse_object(
      R"({"type": "formula", "expr": "x", "transform": {"matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0]], "scale": 1}})",
      "matrix alone");
  refuse_object(R"({"type": "formula", "expr": "x", "color_by": {"expr": "y", "map": "virdis"}})",
                "s.json: objects[0].color_by.map: found the colour map 'virdis'");
  refuse_object(R"({"type": "formula", "expr": "x", "clip": [{}]})",
                "objects[0].clip[0]: found 0 of plane, box and formula");
  refuse_object(R"({"type": "formula", "expr": "x", "color_by": {"map": "viridis"}})",
                "expected one of 'file' and 'expr'");
  refuse_object(R"({"type": "formula", "expr": "x", "color_by": {"expr": "x", "range": [1, 0]}})",
                "color_by.range");
  refuse_object(
      R"({"type": "formula", "expr": "x", "color_by": {"expr": "x", "log": true, "range": [-1, 1]}})",
      "above 0");
}

TEST_CASE("hostile texts end with a sentence") {
  refuse("", "s.json:1:1: this is no JSON");
  refuse("{\"isocast\": 1,\n  oops}", "s.json:2:3: this is no JSON");
  refuse(std::string(100000, '['), "more than 64 levels");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
  refuse(deep, "more than 64 levels");
  refuse("{\"isocast\": 1, \"objects\": [{\"type\": \"formula\", \"expr\": \"x\\u0000\"}]}",
         "objects[0].expr");
  refuse("{\"isocast\": \"\xff\"}", "this is no JSON");
  refuse(R"({"isocast": 1, "objects": [{"type": "formula", "expr": "x", ")" + std::string(5000, 'k') +
             "\": 1}]}",
         "found an unknown key");
  refuse(R"({"isocast": 1e300, "objects": [1]})", "isocast");
}

TEST_CASE("the schema knows the keys that the reader knows") {
  const SceneJson schema = SceneJson::parse(schema_of(scene_rule()));
  const SceneJson& keys = schema["properties"];
  CHECK(keys.size() == scene_rule().keys.size());
  for (const RecordKey& key : scene_rule().keys) CHECK(keys.contains(std::string(key.name)));
  CHECK(schema["additionalProperties"] == false);
  CHECK(schema["$defs"]["object"]["oneOf"].size() == 6);
  // recursion by reference
  const SceneJson& csg = schema["$defs"]["object"]["oneOf"][5];
  CHECK(csg["properties"]["of"]["items"]["$ref"] == "#/$defs/object");
}

TEST_CASE("texts with mistakes anywhere are read or told, and nothing else", "[property]") {
  std::mt19937_64 random(1);
  const std::string good = kScene, marks = "{}[]\",:0-9.etf x";
  int told = 0, read = 0;
  for (std::int64_t n = test::cases(4000, 100000); n > 0; --n) {
    std::string text = good;
    for (std::uint64_t mistakes = 1 + random() % 3; mistakes > 0; --mistakes) {
      const std::size_t at = random() % text.size(),
                        length = std::min<std::size_t>(1 + random() % 12, text.size() - at);
      switch (random() % 4) {
        case 0: text[at] = marks[random() % marks.size()]; break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(at, text.substr(random() % text.size(), length)); break;
        default: text.insert(at, 1, marks[random() % marks.size()]);
      }
    }
    CAPTURE(text);
    try {
      (void)scene_from_text(text, "s.json", "/data");
      ++read;
    } catch (const InputError&) { ++told; } catch (const std::exception& error) {
      FAIL(error.what());
    }
  }
  CHECK(told > 1000);
  CHECK(read > 50);
}
