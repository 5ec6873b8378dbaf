#include <fmt/format.h>
#include <isocast/apps/scene_build/color_by.h>
#include <isocast/apps/scene_build/no_surface.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/base/error.h>
#include <isocast/ray/transformed_surface.h>
#include <isocast/render/environment_file.h>

#include <algorithm>

namespace isocast {
namespace {

// A surface has at most so many iso-values; further ones are objects of their own.
constexpr std::size_t kIsosPerSurface = std::min(kMaxIsos, kMostIsos);

constexpr const char* kClipSolids = "clip solids";

void add_missing(std::vector<std::string>& list, const std::vector<std::string>& more) {
  for (const std::string& word : more)
    if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}

// What the objects need together; what one of them uses was not left out.
void gather_words(BuiltScene& built) {
  built.features.clear(), built.left_out.clear();
  for (const BuiltObject& object : built.objects) {
    add_missing(built.features, object.features);
    add_missing(built.left_out, object.left_out);
  }
  std::erase_if(built.left_out, [&](const std::string& word) {
    return std::ranges::find(built.features, word) != built.features.end();
  });
}

void add_up(BuiltScene& built) {
  for (const BuiltObject& object : built.objects) {
    built.load_ms += object.load_ms;
    built.build_ms += object.build_ms;
    built.volume_bytes += object.volume_bytes;
    built.acceleration_bytes += object.acceleration_bytes;
  }
  gather_words(built);
}

// Part number `part` of a list of iso-values.
std::vector<double> part_of(const std::vector<double>& iso, std::size_t part) {
  const std::size_t begin = part * kIsosPerSurface, end = std::min(iso.size(), begin + kIsosPerSurface);
  return {iso.begin() + static_cast<std::ptrdiff_t>(begin), iso.begin() + static_cast<std::ptrdiff_t>(end)};
}
std::size_t parts_of(const std::vector<double>& iso) {
  return std::max<std::size_t>(1, (iso.size() + kIsosPerSurface - 1) / kIsosPerSurface);
}

// Builds the objects one after the other into a scene.
class Builder {
 public:
  Builder(const SceneDescription& description, const EvaluationSettings& settings, VolumeLibrary& library,
          BuiltScene& built)
      : description_(description), settings_(settings), library_(library), built_(built) {}

  void add_all() {
    for (const ObjectDescription& wanted : description_.objects) {
      if (!wanted.visible && !has_instances(wanted.name)) add_nothing(wanted);
      else if (const auto* const instance = std::get_if<InstanceSource>(&wanted.source))
        add_instances(wanted, *instance);
      else add(wanted);
    }
    // what only instances needed
    for (std::size_t k = 0; k < built_.objects.size(); ++k)
      if (!description_.objects[k].visible) hide(built_.objects[k]);
    if (description_.clips.empty()) return;
    for (std::size_t k = 0; k < built_.objects.size(); ++k) built_.set_clips(k, description_.clips_of(k));
  }

 private:
  [[nodiscard]] std::uint16_t next_number() const {
    const std::size_t number = built_.scene.objects.size();
    if (number >= kNoObject)
      throw InputError(fmt::format("found more than {} objects and instances", kNoObject));
    return static_cast<std::uint16_t>(number);
  }

  [[nodiscard]] bool has_instances(const std::string& name) const {
    return std::ranges::any_of(description_.objects, [&](const ObjectDescription& object) {
      const auto* const instance = std::get_if<InstanceSource>(&object.source);
      return instance && instance->of == name;
    });
  }
  void add_nothing(const ObjectDescription& wanted) {
    BuiltObject nothing;
    nothing.name = wanted.name;
    nothing.place = next_number();
    nothing.iso = wanted.iso;
    nothing.features = {"hidden"};
    built_.scene.objects.push_back({std::make_shared<NoSurface>(), {Material()}});
    built_.objects.push_back(std::move(nothing));
  }
  void hide(BuiltObject& object) {
    object.unclipped.clear();
    for (std::size_t part = 0; part < object.count; ++part)
      built_.scene.objects[object.place + part].surface = std::make_shared<NoSurface>();
  }

  void add(const ObjectDescription& wanted) {
    const std::size_t parts = parts_of(wanted.iso);
    std::shared_ptr<const ColorField> colors;
    if (wanted.color_by) colors = make_color_field(*wanted.color_by, library_);
    std::vector<BuiltObject> pieces;
    for (std::size_t part = 0; part < parts; ++part) {
      ObjectDescription piece = wanted;
      piece.iso = part_of(wanted.iso, part);
      ObjectSurface object = build_object(piece, {settings_, next_number(), library_});
      built_.scene.objects.push_back({std::move(object.surface),
                                      parts == 1 ? std::move(object.materials) : std::vector<Material>(),
                                      object.built.components > 0, colors});
      pieces.push_back(std::move(object.built));
    }
    join(pieces, wanted);
  }
  // Pieces with sixteen iso-values each as one object.
  void join(std::vector<BuiltObject>& pieces, const ObjectDescription& wanted) {
    BuiltObject whole = pieces.front();
    if (pieces.size() > 1) {
      whole.count = pieces.size();
      whole.iso = wanted.iso;
      whole.features[1] = fmt::format("iso:{}", wanted.iso.size());
      for (std::size_t i = 1; i < pieces.size(); ++i) {
        whole.build_ms += pieces[i].build_ms;
        whole.unclipped.push_back(pieces[i].unclipped.front());
        whole.acceleration_bytes += pieces[i].acceleration_bytes;
      }
      whole.move_surface = [pieces](const std::vector<double>& iso) {
        if (parts_of(iso) != pieces.size())
          throw InputError(fmt::format("found {} iso-values, expected about as many as before", iso.size()));
        for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].move_surface(part_of(iso, i));
      };
      if (whole.mask_use)
        whole.mask_use = [pieces] {
          MaskUse use;
          for (const BuiltObject& piece : pieces) use += piece.mask_use();
          return use;
        };
      if (whole.choose_method)
        whole.choose_method = [pieces] {
          std::string method;
          for (const BuiltObject& piece : pieces) method = piece.choose_method();
          return method;
        };
      whole.change_method = [pieces](const auto&... arguments) {
        for (const BuiltObject& piece : pieces) piece.change_method(arguments...);
      };
    }
    built_.objects.push_back(std::move(whole));
    if (pieces.size() > 1) built_.set_iso(built_.objects.size() - 1, wanted.iso, wanted.materials);
  }

  void add_instances(const ObjectDescription& wanted, const InstanceSource& source) {
    const auto of = std::ranges::find(built_.objects, source.of, &BuiltObject::name);
    if (of == built_.objects.end())
      throw InputError(
          fmt::format("instances of '{}': expected an object of that name before them", source.of));
    BuiltObject instances;
    instances.name = wanted.name;
    instances.place = next_number();
    instances.method = of->method;
    instances.proves = of->proves;
    instances.iso = of->iso;
    instances.components = of->components;
    instances.features = {fmt::format("instances:{}", source.places.size())};
    std::shared_ptr<const ColorField> colors;
    if (wanted.color_by) colors = make_color_field(*wanted.color_by, library_);
    const bool own_materials = !wanted.materials.colors.empty() || !wanted.materials.opacities.empty() ||
                               !wanted.materials.reflectivities.empty() ||
                               !wanted.materials.speculars.empty();
    for (std::size_t i = 0; i < source.places.size(); ++i)
      for (std::size_t part = 0; part < of->count; ++part) {
        const auto number = static_cast<std::uint16_t>(of->place + part);
        SceneObject copy = built_.scene.objects[number];
        copy.surface = std::make_shared<TransformedSurface>(copy.surface, wanted.place * source.places[i],
                                                            number, next_number());
        if (own_materials) copy.materials = materials_of(wanted.materials, copy.materials.size());
        if (own_materials && source.places.size() > 1 && copy.materials.size() == 1)
          copy.materials = {material_of(wanted.materials, i)};
        if (colors) copy.color_field = colors;
        instances.unclipped.push_back(copy.surface);
        built_.scene.objects.push_back(std::move(copy));
      }
    instances.count = built_.scene.objects.size() - instances.place;
    built_.objects.push_back(std::move(instances));
    if (!wanted.clips.empty()) built_.set_clips(built_.objects.size() - 1, wanted.clips);
  }

  const SceneDescription& description_;
  const EvaluationSettings& settings_;
  VolumeLibrary& library_;
  BuiltScene& built_;
};

}  // namespace

void BuiltScene::set_iso(std::size_t object, const std::vector<double>& iso,
                         const MaterialDescription& materials) {
  BuiltObject& moved = objects[object];
  if (!moved.move_surface)
    throw InputError(fmt::format("object '{}' has no iso-values that can be moved", moved.name));
  moved.iso = iso;
  moved.move_surface(iso);
  const std::vector<Material> all =
      materials_of(materials, moved.components > 0 ? moved.components : iso.size());
  for (std::size_t part = 0; part < moved.count; ++part) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(part * kIsosPerSurface);
    scene.objects[moved.place + part].materials =
        moved.count == 1 ? all : std::vector<Material>(begin, std::min(begin + kIsosPerSurface, all.end()));
  }
  for (std::string& word : moved.features)
    if (word.starts_with("iso:")) word = fmt::format("iso:{}", iso.size());
  gather_words(*this);
}

bool BuiltScene::choose_method(std::size_t object) {
  BuiltObject& chosen = objects[object];
  if (!chosen.choose_method) return false;
  const std::string before = chosen.method;
  chosen.method = chosen.choose_method();
  return chosen.method != before;
}

void BuiltScene::set_clips(std::size_t object, const std::vector<SolidDescription>& clips) {
  BuiltObject& cut = objects[object];
  std::size_t number = cut.place;
  for (const auto& surface : clipped(cut.unclipped, clips, number)) scene.objects[number++].surface = surface;
  for (std::vector<std::string>* const list : {&cut.features, &cut.left_out}) std::erase(*list, kClipSolids);
  (clips.empty() ? cut.left_out : cut.features).emplace_back(kClipSolids);
  gather_words(*this);
}

bool BuiltScene::proves() const { return std::ranges::any_of(objects, &BuiltObject::proves); }

BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings) {
  VolumeLibrary library;
  return build_scene(description, settings, library);
}

BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings,
                       VolumeLibrary& library) {
  if (description.objects.empty()) throw InputError("found a scene without objects, expected one or more");
  BuiltScene built;
  built.scene.background = description.background;
  if (!description.environment.empty()) built.scene.environment = read_environment(description.environment);
  Builder(description, settings, library, built).add_all();
  add_up(built);
  built.scene.lights = description.lights;
  built.scene.ambient_occlusion = description.ambient_occlusion;
  built.scene.shadows = description.shadows;
  return built;
}

}  // namespace isocast
