#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/viewer/scene_document.h>
#include <isocast/base/mapped_file.h>
#include <isocast/scene/mesh/mesh.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace isocast::viewer {
namespace {

// The name that means the same from every folder.
void make_full(SceneJson& record, const char* key, const std::filesystem::path& folder) {
  if (record.contains(key))
    record[key] = std::filesystem::absolute(folder / record[key].get<std::string>()).lexically_normal();
}

void make_files_full(SceneJson& object, const std::filesystem::path& folder) {
  make_full(object, "file", folder);
  if (object.contains("expr") && object["expr"].get<std::string>().ends_with(".vm"))
    make_full(object, "expr", folder);
  if (object.contains("color_by")) {
    SceneJson& colors = object["color_by"];
    make_full(colors, "file", folder);
    if (colors.value("map", "").ends_with(".json")) make_full(colors, "map", folder);
  }
  if (object["type"] == "csg")
    for (SceneJson& operand : object["of"]) make_files_full(operand, folder);
}

SceneJson read_document(const std::string& file) {
  const MappedFile mapped = map_file(file);
  SceneJson document =
      parse_scene_json({reinterpret_cast<const char*>(mapped.bytes.data()), mapped.bytes.size()}, file);
  check_mapped_files();
  check_rule(document, scene_rule(), file);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (SceneJson& object : document["objects"]) make_files_full(object, folder);
  if (document.contains("background") && document["background"].is_object())
    make_full(document["background"], "environment", folder);
  return document;
}

// The values of `--param`, by name.
SceneJson parameters_json(const RenderWords& words) {
  SceneJson parameters = SceneJson::object();
  for (const Parameter& parameter : parse_parameters(words.params, "--param"))
    parameters[parameter.name] = parameter.value.value;
  return parameters;
}

// "KEY=VALUE" as the keys of a record: numbers where they are some.
SceneJson settings_json(const std::vector<std::string>& set) {
  SceneJson settings = SceneJson::object();
  for (const std::string& word : set) {
    const auto [key, value] = parse_key_value(word, "--set");
    const SceneJson number = SceneJson::parse(value, nullptr, false);
    settings[key] = number.is_number() ? number : SceneJson(value);
  }
  return settings;
}

void put_reading(const ReadOptions& read, SceneJson& object) {
  if (read.dims) object["dims"] = *read.dims;
  if (read.type) object["sample_type"] = name_of(*read.type);
  if (read.big_endian) object["endian"] = "big";
  if (read.skip) object["skip"] = read.skip;
  if (!read.grid.empty()) object["grid"] = read.grid;
}

SceneJson object_of(const RenderWords& words) {
  const std::string text = typed_formula(words.input);
  SceneJson object = SceneJson::object();
  if (has_mesh_extension(text)) object = {{"type", "mesh"}, {"file", text}};
  else if (is_volume_file(text, parse_parameters(words.params, "--param")))
    object = {{"type", "volume"}, {"file", text}};
  else if (text.starts_with('@')) object = {{"type", "surface"}, {"id", text.substr(1)}};
  else object = {{"type", "formula"}, {"expr", text}};
  make_files_full(object, {});
  put_reading(words.read, object);
  if (object.contains("file")) return object;
  if (!words.params.empty()) object["params"] = parameters_json(words);
  if (words.by_component) object["color_components"] = true;
  if (words.domain.empty()) return object;
  const Domain domain = parse_domain(words.domain, "--domain");
  for (std::size_t a = 0; a < 3; ++a) object["domain"].push_back({domain.lo[a], domain.hi[a]});
  return object;
}

// Options that a scene of one object takes, too.
void put_words(const RenderWords& words, SceneJson& object) {
  if (!words.iso.empty()) object["iso"] = parse_numbers(words.iso, "--iso");
  if (words.method != "auto") object["method"] = words.method, object.erase("set");
  if (!words.set.empty()) object["set"].update(settings_json(words.set));
  if (words.normals != "gradient") object["normals"] = words.normals;
  const MaterialDescription looks = describe_materials(words);
  if (!looks.colors.empty()) object["material"]["color"] = looks.colors;
  if (!looks.opacities.empty()) object["material"]["opacity"] = looks.opacities;
  if (!looks.reflectivities.empty()) object["material"]["reflectivity"] = looks.reflectivities;
  for (const std::string& formula : words.clips) {
    SceneJson clip = {{"formula", typed_formula(formula)}};
    if (!words.params.empty()) clip["params"] = parameters_json(words);
    object["clip"].push_back(std::move(clip));
  }
}

std::vector<std::string> settings_of(const SceneJson& object) {
  std::vector<std::string> set;
  if (object.contains("set"))
    for (const auto& [key, value] : object["set"].items())
      set.push_back(key + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  return set;
}

ColorWords colors_of(const SceneJson& object) {
  ColorWords words;
  if (!object.contains("color_by")) return words;
  const SceneJson& colors = object["color_by"];
  words.of = colors.contains("file") ? colors["file"] : colors["expr"];
  words.map = colors.value("map", words.map);
  if (colors.contains("range"))
    words.range = fmt::format("{},{}", colors["range"][0].get<double>(), colors["range"][1].get<double>());
  words.logarithmic = colors.value("log", false);
  return words;
}

void write_colors(const ColorWords& words, SceneJson& object) {
  const ColorWords before = colors_of(object);
  if (words == before) return;
  if (words.of.empty()) {
    object.erase("color_by");
    return;
  }
  SceneJson& colors = object["color_by"];
  if (words.of != before.of) {
    const bool is_file = is_volume_file(words.of, {});
    colors = {{is_file ? "file" : "expr", words.of}};
    make_full(colors, "file", {});
  }
  colors["map"] = words.map;
  if (words.map.ends_with(".json")) make_full(colors, "map", {});
  if (words.range.empty()) colors.erase("range");
  else colors["range"] = parse_numbers(words.range, "range");
  colors["log"] = words.logarithmic;
}

void write_surfaces(const SessionObject& from, SceneJson& object) {
  std::vector<double> values, opacities, reflectivities;
  std::vector<Color> colors;
  for (const IsoSurface& surface : from.surfaces) {
    if (!surface.visible) continue;
    values.push_back(surface.value), colors.push_back(surface.color);
    opacities.push_back(surface.opacity), reflectivities.push_back(surface.reflectivity);
  }
  if (values.empty()) {
    object["visible"] = false;
    return;
  }
  if (from.has_iso()) object["iso"] = values;
  if (object.value("color_components", false)) return;
  SceneJson& material = object["material"];
  material["color"] = colors, material["opacity"] = opacities;
  if (std::ranges::any_of(reflectivities, [](double share) { return share != 0; }))
    material["reflectivity"] = reflectivities;
  else material.erase("reflectivity");
}

}  // namespace

SceneJson document_of(const RenderWords& words) {
  SceneJson document = {{"isocast", 1}};
  if (is_scene_file(words.input)) document = read_document(words.input);
  else document["objects"].push_back(object_of(words));
  if (document["objects"].size() == 1) put_words(words, document["objects"][0]);
  return document;
}

void clear_object_words(RenderWords& words) {
  for (std::string* text : {&words.iso, &words.colors, &words.opacity, &words.reflectivity, &words.domain})
    text->clear();
  words.method = "auto", words.normals = "gradient";
  words.set.clear(), words.params.clear(), words.clips.clear();
  words.by_component = false;
  words.read = {};
}

SessionObject read_object(const SceneJson& object) {
  return {object.value("name", ""),
          object["type"],
          object.value("method", "auto"),
          settings_of(object),
          object.value("visible", true),
          colors_of(object),
          {},
          {}};
}

void write_object(const SessionObject& from, SceneJson& object) {
  if (from.method != object.value("method", "auto")) object["method"] = from.method;
  if (from.set != settings_of(object)) object["set"] = settings_json(from.set);
  if (from.visible != object.value("visible", true)) object["visible"] = from.visible;
  write_colors(from.color_by, object);
  if (from.surfaces != from.adopted) write_surfaces(from, object);
}

void stop_animated_iso(const std::string& name, SceneJson& document) {
  if (!document.contains("animation")) return;
  for (SceneJson& key : document["animation"]["keys"])
    if (key.contains("iso")) key["iso"].erase(name);
}

std::string text_of(const SceneJson& document, bool for_people) {
  return document.dump(for_people ? 2 : -1, ' ', false, SceneJson::error_handler_t::replace);
}

std::string built_part(const std::string& scene_text) {
  SceneJson document = parse_scene_json(scene_text, "the scene");
  document.erase("clip"), document.erase("animation");
  std::set<std::string> copied;
  for (const SceneJson& object : document["objects"])
    if (object["type"] == "instance") copied.insert(object["of"].get<std::string>());
  for (SceneJson& object : document["objects"]) {
    if (object["type"] == "instance" || copied.contains(object.value("name", ""))) continue;
    if (!read_object(object).has_iso()) continue;
    if (object["type"] == "volume") object.erase("method"), object.erase("set");
    object.erase("material");
    const SceneJson iso = object.contains("iso") ? object["iso"] : SceneJson();
    object["iso"] = iso.is_array() ? (iso.size() + 15) / 16 : 1;  // surfaces of sixteen
  }
  return document.dump();
}

}  // namespace isocast::viewer
