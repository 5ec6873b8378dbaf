#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/apps/scene_build/build_object.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/viewer/session.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>

#include <algorithm>
#include <filesystem>

namespace isocast::viewer {
namespace {

IsoSurface surface_of(double value, const Material& material) {
  return {value, material.color, material.opacity, material.reflectivity, true};
}

// The numbers of the visible surfaces, as short as they can be read back.
template <class Number> std::string list(const SessionObject& object, Number number) {
  std::vector<std::string> words;
  for (const IsoSurface& surface : object.surfaces)
    if (surface.visible) words.push_back(fmt::format("{}", number(surface)));
  return fmt::format("{}", fmt::join(words, ","));
}

// The palette's colours of as many surfaces as are visible.
std::string default_colors(const SessionObject& object) {
  std::size_t i = 0;
  return list(object, [&](const IsoSurface&) { return hex_of(material_of({}, i++).color); });
}

std::string vector_text(const Double3& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

void put_camera(const Camera& camera, RenderWords& words) {
  words.position = vector_text(camera.position);
  words.target = vector_text(camera.target);
  words.up = vector_text(camera.up);
  words.fov = camera.ortho_height ? "" : fmt::format("{}", camera.fov);
  words.ortho = camera.ortho_height ? fmt::format("{}", *camera.ortho_height) : "";
}

void put_surfaces(const SessionObject& object, RenderWords& words) {
  if (object.surfaces == object.adopted) return;
  if (std::ranges::none_of(object.surfaces, &IsoSurface::visible)) {  // an iso-value that nobody sees
    if (object.has_iso()) words.iso = fmt::format("{}", object.surfaces.front().value);
    words.colors.clear();
    words.reflectivity.clear();
    words.opacity.assign(1, '0');
    return;
  }
  if (object.has_iso()) words.iso = list(object, [](const IsoSurface& s) { return s.value; });
  if (words.by_component) return;
  words.colors = list(object, [](const IsoSurface& s) { return hex_of(s.color); });
  words.opacity = list(object, [](const IsoSurface& s) { return s.opacity; });
  words.reflectivity = list(object, [](const IsoSurface& s) { return s.reflectivity; });
  const auto any = [&](auto unusual) { return std::ranges::any_of(object.surfaces, unusual); };
  if (!any([](const IsoSurface& s) { return s.visible && s.opacity != 1; })) words.opacity.clear();
  if (!any([](const IsoSurface& s) { return s.visible && s.reflectivity != 0; })) words.reflectivity.clear();
  if (words.colors == default_colors(object)) words.colors.clear();
}

}  // namespace

std::string hex_of(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb_code(color[0]), srgb_code(color[1]), srgb_code(color[2]));
}

Session start_session(const RenderWords& words) {
  Session session;
  session.words = words;
  if (is_scene_file(words.input)) {
    session.document = document_of(words);
    clear_object_words(session.words);
    session.objects.clear();
    for (const SceneJson& object : (*session.document)["objects"])
      session.objects.push_back(read_object(object));
    return session;
  }
  SessionObject& object = session.object();
  object = read_object(document_of(words)["objects"][0]);
  object.method = words.method, object.set = words.set;
  if (object.type == "volume" && words.input.find('%') != std::string::npos) {
    session.numbers = numbers_of_files(words.input);
    if (session.numbers) session.frame = session.numbers->front();
  }
  const MaterialDescription looks = describe_materials(words);
  const std::vector<double> values =
      words.iso.empty() ? std::vector<double>() : parse_numbers(words.iso, "--iso");
  adopt_surfaces(object, values, materials_of(looks, values.size()));
  return session;
}

std::optional<std::array<int, 2>> Session::frames() const {
  if (!document || !document->contains("animation")) return numbers;
  return (*document)["animation"]["frames"].get<std::array<int, 2>>();
}

void adopt_surfaces(SessionObject& object, const std::vector<double>& values,
                    const std::vector<Material>& materials) {
  object.surfaces.clear();
  for (std::size_t i = 0; i < values.size() && i < materials.size(); ++i)
    object.surfaces.push_back(surface_of(values[i], materials[i]));
  object.adopted = object.surfaces;
}

void add_surface(SessionObject& object, double value) {
  object.surfaces.push_back(surface_of(value, material_of({}, object.surfaces.size())));
}

RenderWords words_of(const Session& session, int width, int height, const std::vector<std::string>& clips) {
  RenderWords words = session.words;
  words.size = fmt::format("{}x{}", width, height);
  if (session.camera) put_camera(*session.camera, words);
  if (session.frame) words.frames = fmt::format("{0}:{0}", *session.frame);
  const SessionObject& first = session.objects.front();
  if (!session.document && first.color_by.of.empty()) {
    words.method = first.method, words.set = first.set;
    words.clips.insert(words.clips.end(), clips.begin(), clips.end());
    put_surfaces(first, words);
    return words;
  }
  SceneJson document = session.document ? *session.document : document_of(session.words);
  for (std::size_t k = 0; k < session.objects.size(); ++k) {
    const SessionObject& object = session.objects[k];
    write_object(object, document["objects"][k]);
    if (object.surfaces != object.adopted) stop_animated_iso(object.name, document);
  }
  for (const std::string& formula : clips) document["clip"].push_back({{"formula", formula}});
  words.scene_text = text_of(document);
  clear_object_words(words);
  if (!session.document) words.input = "scene.json";
  return words;
}

RenderWords write_scene(const Session& session, RenderWords words, const std::string& output) {
  if (words.scene_text.empty()) return words;
  const bool as_it_was = session.document && words.scene_text == text_of(*session.document);
  if (!as_it_was) {
    words.input = std::filesystem::path(output).replace_extension(".scene.json");
    write_text_file(words.input, text_of(parse_scene_json(words.scene_text, words.input), true) + "\n");
  }
  words.scene_text.clear();
  return words;
}

}  // namespace isocast::viewer
