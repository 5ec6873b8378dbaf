#include <fmt/format.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/scene_build/scene_objects.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/nearest_name.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace isocast {
namespace {

CameraWishes camera_from(const SceneJson& value, const std::string& path, const SceneContext& context) {
  CameraWishes camera;
  const auto point = [&](const char* key, std::optional<Double3>& to) {
    if (value.contains(key)) to = point_from_json(value[key]);
  };
  point("position", camera.position), point("target", camera.target), point("up", camera.up);
  if (value.contains("fov")) camera.fov = value["fov"].get<double>();
  if (value.contains("ortho")) camera.ortho_height = value["ortho"].get<double>();
  if (camera.fov && camera.ortho_height)
    throw InputError(fmt::format("{}: {}: found fov and ortho, expected one of them", context.source, path));
  return camera;
}

void read_cameras(const SceneJson& value, const SceneContext& context, SceneDescription& scene) {
  if (value.contains("camera") && value.contains("cameras"))
    throw InputError(fmt::format("{}: found camera and cameras, expected one of them", context.source));
  if (value.contains("camera")) scene.camera = camera_from(value["camera"], "camera", context);
  if (!value.contains("cameras")) return;
  for (const auto& [name, camera] : value["cameras"].items())
    scene.cameras[name] = camera_from(camera, fmt::format("cameras.{}", name), context);
  if (!scene.cameras.empty()) scene.camera = scene.cameras.begin()->second;
}

void read_lights(const SceneJson& value, const SceneContext& context, SceneDescription& scene) {
  if (!value.contains("lights")) return;
  for (std::size_t i = 0; i < value["lights"].size(); ++i) {
    const SceneJson& light = value["lights"][i];
    if (light["type"] == "ambient_occlusion") {
      scene.ambient_occlusion = {light.value("samples", 16), light.value("radius", Box::inf)};
      continue;
    }
    const Double3 direction = point_from_json(light["direction"]);
    if (!(length(direction) > 0) || !std::isfinite(length(direction)))
      throw InputError(fmt::format(
          "{}: lights[{}].direction: found no direction, expected one towards the light", context.source, i));
    scene.lights.push_back(direction);
  }
}

void read_background(const SceneJson& value, const SceneContext& context, SceneDescription& scene) {
  if (!value.contains("background")) return;
  const SceneJson& background = value["background"];
  if (background.is_object())
    scene.environment = context.folder / background["environment"].get<std::string>();
  else scene.background = color_from_json(background);
}

std::vector<double> iso_list(const SceneJson& value) {
  return value.is_number() ? std::vector{value.get<double>()} : value.get<std::vector<double>>();
}

Animation animation_from(const SceneJson& value, const SceneContext& context, const SceneDescription& scene) {
  Animation animation{value["frames"][0], value["frames"][1], {}};
  const auto fail = [&](const std::string& path, const std::string& what) {
    throw InputError(fmt::format("{}: animation.{}: {}", context.source, path, what));
  };
  if (animation.first > animation.last) fail("frames", "found last before first");
  for (std::size_t i = 0; value.contains("keys") && i < value["keys"].size(); ++i) {
    const SceneJson& from = value["keys"][i];
    const std::string path = fmt::format("keys[{}]", i);
    AnimationKey key;
    key.frame = from["frame"];
    if (!animation.keys.empty() && key.frame <= animation.keys.back().frame)
      fail(path + ".frame", "expected keys by rising frame");
    if (from.contains("time")) key.time = from["time"].get<double>();
    if (from.contains("camera")) {
      SceneDescription one = scene;
      try {
        use_camera(one, from["camera"]);
      } catch (const InputError& error) { fail(path + ".camera", error.what()); }
      key.camera = one.camera;
    }
    if (from.contains("params")) key.parameters = from["params"].get<std::map<std::string, double>>();
    if (from.contains("iso"))
      for (const auto& [name, iso] : from["iso"].items()) key.iso[name] = iso_list(iso);
    animation.keys.push_back(std::move(key));
  }
  return animation;
}

// The names of objects and of all operands in them are there once.
void add_names(const std::vector<ObjectDescription>& objects, const std::string& source,
               std::set<std::string>& names) {
  for (const ObjectDescription& object : objects) {
    if (!object.name.empty() && !names.insert(object.name).second)
      throw InputError(fmt::format("{}: two objects have the name {}", source, in_quotes(object.name)));
    if (const auto* const csg = std::get_if<CsgSource>(&object.source)) add_names(csg->of, source, names);
  }
}

// Everything that is called by a name exists.
void check_names(const SceneDescription& scene, const std::string& source) {
  std::set<std::string> names;
  add_names(scene.objects, source, names);
  const auto require = [&](const std::string& name, const std::string& where) {
    if (names.contains(name)) return;
    const std::string near = nearest_name(name, {names.begin(), names.end()});
    throw InputError(fmt::format("{}: {}: no object has the name {}{}", source, where, in_quotes(name),
                                 near.empty() ? "" : fmt::format(", did you mean '{}'?", near)));
  };
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (const auto* instance = std::get_if<InstanceSource>(&scene.objects[i].source))
      require(instance->of, fmt::format("objects[{}].of", i));
  if (!scene.animation) return;
  for (std::size_t i = 0; i < scene.animation->keys.size(); ++i) {
    const AnimationKey& key = scene.animation->keys[i];
    for (const auto& [name, value] : key.parameters)
      require(name.substr(0, name.find('.')), fmt::format("animation.keys[{}].params", i));
    for (const auto& [name, iso] : key.iso) require(name, fmt::format("animation.keys[{}].iso", i));
  }
}

}  // namespace

bool is_scene_file(const std::string& word) { return word.ends_with(".json"); }

void use_camera(SceneDescription& scene, const std::string& name) {
  const auto camera = scene.cameras.find(name);
  if (camera != scene.cameras.end()) {
    scene.camera = camera->second;
    return;
  }
  std::string names;
  for (const auto& [known, wishes] : scene.cameras) add_to_list(names, known);
  throw InputError(fmt::format("no camera has the name {}, expected {}", in_quotes(name),
                               names.empty() ? "a scene with cameras" : "one of: " + names));
}

SceneDescription scene_from_text(const std::string& text, const std::string& source,
                                 const std::filesystem::path& folder) {
  const SceneJson value = parse_scene_json(text, source);
  check_rule(value, scene_rule(), source);
  const SceneContext context{source, folder, value.value("time", 0.0)};
  SceneDescription scene;
  scene.time = context.time;
  scene.shadows = value.value("shadows", false);
  read_cameras(value, context, scene);
  read_lights(value, context, scene);
  read_background(value, context, scene);
  const auto wish = [&](const char* key, auto& to) {
    if (value.contains(key)) to = value[key].get<typename std::decay_t<decltype(to)>::value_type>();
  };
  wish("size", scene.wishes.size), wish("spp", scene.wishes.spp);
  wish("transparency_depth", scene.wishes.transparency_depth), wish("reflections", scene.wishes.reflections);
  if (value.contains("clip")) scene.clips = clips_from_json(value["clip"], "clip", context);
  scene.objects.clear();
  for (std::size_t i = 0; i < value["objects"].size(); ++i)
    scene.objects.push_back(object_from_json(value["objects"][i], fmt::format("objects[{}]", i), context));
  if (value.contains("animation")) scene.animation = animation_from(value["animation"], context, scene);
  check_names(scene, source);
  return scene;
}

SceneDescription read_scene(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  const std::string text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  check_mapped_files();
  return scene_from_text(text, path.string(), path.parent_path());
}

}  // namespace isocast
