#include <fmt/format.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cstdio>

namespace isocast {
namespace {

double mixed(double a, double b, double part) { return part == 0 ? a : part == 1 ? b : a + part * (b - a); }

std::optional<double> mixed(const std::optional<double>& a, const std::optional<double>& b, double part) {
  return a && b ? mixed(*a, *b, part) : a;
}
std::optional<Double3> mixed(const std::optional<Double3>& a, const std::optional<Double3>& b, double part) {
  if (!a || !b) return a;
  Double3 point;
  for (int i = 0; i < 3; ++i) point[i] = mixed((*a)[i], (*b)[i], part);
  return point;
}
CameraWishes mixed(const CameraWishes& a, const CameraWishes& b, double part) {
  return {mixed(a.position, b.position, part), mixed(a.target, b.target, part), mixed(a.up, b.up, part),
          mixed(a.fov, b.fov, part), mixed(a.ortho_height, b.ortho_height, part)};
}
std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double part) {
  if (a.size() != b.size())
    throw InputError(
        fmt::format("animation: found {} and {} iso-values of one object, expected as many in all keys",
                    a.size(), b.size()));
  std::vector<double> values;
  for (std::size_t i = 0; i < a.size(); ++i) values.push_back(mixed(a[i], b[i], part));
  return values;
}

// What the keys say at a frame; `named` gives a key's value, or null where it has none.
template <class Named> auto value_at(const std::vector<AnimationKey>& keys, int frame, Named named) {
  using Value = std::decay_t<decltype(*named(keys.front()))>;
  const AnimationKey *before = nullptr, *behind = nullptr;
  for (const AnimationKey& key : keys) {
    if (!named(key)) continue;
    if (key.frame <= frame) before = &key;
    else if (!behind) behind = &key;
  }
  if (!before && !behind) return std::optional<Value>();
  if (!before || !behind) return std::optional<Value>(*named(before ? *before : *behind));
  const double part = static_cast<double>(frame - before->frame) / (behind->frame - before->frame);
  return std::optional<Value>(mixed(*named(*before), *named(*behind), part));
}

// The names of a map in any of the keys.
template <class Map> std::vector<std::string> names_in(const std::vector<AnimationKey>& keys, Map map) {
  std::vector<std::string> names;
  for (const AnimationKey& key : keys)
    for (const auto& [name, value] : key.*map) names.push_back(name);
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  return names;
}

// Every object, and the operands of each right behind it.
template <class Action> void for_each(std::vector<ObjectDescription>& objects, const Action& action) {
  for (ObjectDescription& object : objects) {
    action(object);
    if (auto* const csg = std::get_if<CsgSource>(&object.source)) for_each(csg->of, action);
  }
}

ObjectDescription& object_named(SceneDescription& scene, const std::string& name) {
  ObjectDescription* found = nullptr;
  for_each(scene.objects, [&](ObjectDescription& object) {
    if (!found && object.name == name) found = &object;
  });
  if (!found) throw InputError(fmt::format("animation: no object has the name '{}'", name));
  return *found;
}

void set_parameter(SceneDescription& scene, const std::string& name, double value) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  const std::string own = name.substr(std::min(dot + 1, name.size()));
  auto* const formula = std::get_if<FormulaSource>(&object_named(scene, name.substr(0, dot)).source);
  const bool known =
      formula && (formula->text.starts_with('@') ||
                  std::ranges::find(formula->parameters, own, &Parameter::name) != formula->parameters.end());
  if (!known)
    throw InputError(fmt::format(
        "animation: found the parameter '{}', expected 'object.parameter' of a formula that has it in params",
        name));
  formula->parameters.push_back({own, shortest_constant(value)});
}

void set_iso(SceneDescription& scene, const std::string& name, const std::vector<double>& iso) {
  ObjectDescription& object = object_named(scene, name);
  if (!std::holds_alternative<VolumeSource>(object.source) &&
      !std::holds_alternative<FormulaSource>(object.source))
    throw InputError(
        fmt::format("animation: found iso-values of '{}', expected the name of a volume or a formula", name));
  object.iso = iso;
}

void set_time(ObjectDescription& object, double time) {
  if (object.time) return;
  const auto follow = [&](auto& field) {
    if (auto* const formula = std::get_if<FormulaSource>(&field)) formula->time = time;
  };
  follow(object.source);
  if (object.color_by) follow(object.color_by->field);
  for (SolidDescription& clip : object.clips) clip.time = time;
}

void set_files(ObjectDescription& object, int frame) {
  const auto number = [&](std::filesystem::path& file) { file = numbered_file(file, frame); };
  if (auto* const volume = std::get_if<VolumeSource>(&object.source)) number(volume->file);
  if (auto* const mesh = std::get_if<MeshSource>(&object.source)) number(mesh->file);
  if (!object.color_by) return;
  if (auto* const volume = std::get_if<VolumeSource>(&object.color_by->field)) number(volume->file);
}

void apply_keys(const std::vector<AnimationKey>& keys, int frame, SceneDescription& scene) {
  const auto of = [](const auto& optional) { return optional ? &*optional : nullptr; };
  if (const auto time = value_at(keys, frame, [&](const AnimationKey& key) { return of(key.time); }))
    scene = at_time(scene, *time);
  if (const auto camera = value_at(keys, frame, [&](const AnimationKey& key) { return of(key.camera); }))
    scene.camera = *camera;

  const auto in = [](const auto& map, const std::string& name) {
    const auto found = map.find(name);
    return found == map.end() ? nullptr : &found->second;
  };
  const auto parameters = names_in(keys, &AnimationKey::parameters);
  for (const std::string& name : parameters)
    set_parameter(scene, name,
                  *value_at(keys, frame, [&](const AnimationKey& key) { return in(key.parameters, name); }));
  for (const std::string& name : names_in(keys, &AnimationKey::iso))
    set_iso(scene, name, *value_at(keys, frame, [&](const AnimationKey& key) { return in(key.iso, name); }));
  // formulas with other parameters are read again
  if (parameters.empty()) return;
  for_each(scene.objects, [](ObjectDescription& object) {
    if (auto* const formula = std::get_if<FormulaSource>(&object.source))
      formula->expression = read_formula({formula->text, formula->parameters, formula->domain}).expression;
  });
}

bool is_numbered(const std::filesystem::path& file) {
  return file.filename().string().find('%') != std::string::npos;
}

// Whether any of its files has the frame's number in its name.
bool follows_frames(const ObjectDescription& object) {
  if (const auto* const csg = std::get_if<CsgSource>(&object.source))
    return std::ranges::any_of(csg->of, follows_frames);
  if (const auto* const volume = std::get_if<VolumeSource>(&object.source);
      volume && is_numbered(volume->file))
    return true;
  if (const auto* const mesh = std::get_if<MeshSource>(&object.source); mesh && is_numbered(mesh->file))
    return true;
  const auto* const field = object.color_by ? std::get_if<VolumeSource>(&object.color_by->field) : nullptr;
  return field && is_numbered(field->file);
}

// Whether other iso-values only move its surfaces.
bool moves(const SceneDescription& scene, const std::string& name) {
  return std::ranges::any_of(scene.objects, [&](const ObjectDescription& object) {
    return object.name == name && (std::holds_alternative<VolumeSource>(object.source) ||
                                   std::holds_alternative<FormulaSource>(object.source));
  });
}

}  // namespace

SceneDescription description_at(const SceneDescription& scene, int frame) {
  SceneDescription at = scene;
  for_each(at.objects, [&](ObjectDescription& object) { set_files(object, frame); });
  if (scene.animation && !scene.animation->keys.empty()) apply_keys(scene.animation->keys, frame, at);
  return at;
}

SceneDescription at_time(const SceneDescription& scene, double time) {
  SceneDescription at = scene;
  at.time = time;
  for (SolidDescription& clip : at.clips) clip.time = time;
  for_each(at.objects, [&](ObjectDescription& object) { set_time(object, time); });
  return at;
}

std::array<int, 2> frames_of(const SceneDescription& scene) {
  if (!scene.animation) return {0, 0};
  return {scene.animation->first, scene.animation->last};
}

bool rebuilt_by_frames(const SceneDescription& scene) {
  if (std::ranges::any_of(scene.objects, follows_frames)) return true;
  return scene.animation && std::ranges::any_of(scene.animation->keys, [&](const AnimationKey& key) {
           return key.time || !key.parameters.empty() ||
                  !std::ranges::all_of(key.iso, [&](const auto& iso) { return moves(scene, iso.first); });
         });
}

std::filesystem::path numbered_file(const std::filesystem::path& file, int frame) {
  const std::string name = file.filename().string();
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos) return file;
  std::size_t end = percent + 1;
  int width = 0;
  if (end < name.size() && name[end] == '0') ++end;
  while (end < name.size() && name[end] >= '1' && name[end] <= '9' && width == 0) width = name[end++] - '0';
  if (end >= name.size() || name[end] != 'd' || name.find('%', percent + 1) != std::string::npos)
    throw InputError(
        fmt::format("{}: found a %, expected one %d or %04d for the number of the frame", file.string()));
  const std::string digits =
      name[percent + 1] == '0' ? fmt::format("{:0{}}", frame, width) : fmt::format("{:{}}", frame, width);
  return file.parent_path() / (name.substr(0, percent) + digits + name.substr(end + 1));
}

std::optional<std::array<int, 2>> numbers_of_files(const std::filesystem::path& file) {
  const std::string begin = file.filename().string().substr(0, file.filename().string().find('%'));
  std::optional<std::array<int, 2>> numbers;
  std::error_code unreadable;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const std::string name = entry.path().filename().string();
    int number = 0;
    if (!name.starts_with(begin) || std::sscanf(name.c_str() + begin.size(), "%d", &number) != 1) continue;
    if (numbered_file(file, number).filename() != name) continue;
    if (!numbers) numbers = {number, number};
    numbers = {std::min((*numbers)[0], number), std::max((*numbers)[1], number)};
  }
  return numbers;
}

}  // namespace isocast
