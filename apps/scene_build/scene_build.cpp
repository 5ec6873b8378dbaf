#include <fmt/format.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/base/error.h>
#include <isocast/render/environment_file.h>

#include <algorithm>

namespace isocast {
namespace {

void add_missing(std::vector<std::string>& list, const std::vector<std::string>& more) {
  for (const std::string& word : more)
    if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}

// What the objects need together; what one of them uses was not left out.
void add_up(BuiltScene& built) {
  for (const BuiltObject& object : built.objects) {
    add_missing(built.features, object.features);
    add_missing(built.left_out, object.left_out);
    built.load_ms += object.load_ms;
    built.build_ms += object.build_ms;
    built.volume_bytes += object.volume_bytes;
    built.acceleration_bytes += object.acceleration_bytes;
  }
  std::erase_if(built.left_out, [&](const std::string& word) {
    return std::ranges::find(built.features, word) != built.features.end();
  });
}

}  // namespace

void BuiltScene::set_iso(std::size_t object, const std::vector<double>& iso,
                         const MaterialDescription& materials) {
  BuiltObject& moved = objects[object];
  moved.iso = iso;
  moved.move_surface(iso);
  SceneObject& shown = scene.objects[moved.place];
  shown.materials.clear();
  const std::size_t count = moved.components > 0 ? moved.components : iso.size();
  for (std::size_t i = 0; i < count; ++i) shown.materials.push_back(material_of(materials, i));
  shown.by_component = moved.components > 0;
}

bool BuiltScene::proves() const { return std::ranges::any_of(objects, &BuiltObject::proves); }

BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings) {
  if (description.objects.empty() || description.objects.size() >= kNoObject)
    throw InputError(
        fmt::format("found {} objects, expected 1 to {}", description.objects.size(), kNoObject - 1));
  BuiltScene built;
  built.scene.background = description.background;
  if (!description.environment.empty()) built.scene.environment = read_environment(description.environment);
  for (const ObjectDescription& wanted : description.objects) {
    ObjectSurface object =
        build_object(wanted, settings, static_cast<std::uint16_t>(built.scene.objects.size()));
    built.scene.objects.push_back({std::move(object.surface), {}});
    built.objects.push_back(std::move(object.built));
    built.set_iso(built.objects.size() - 1, built.objects.back().iso, wanted.materials);
  }
  add_up(built);
  built.scene.lights = description.lights;
  built.scene.shadows = description.shadows;
  return built;
}

}  // namespace isocast
