#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/build_object.h>
#include <isocast/apps/viewer/session.h>
#include <isocast/render/image_file.h>

#include <algorithm>

namespace isocast::viewer {
namespace {

IsoSurface surface_of(double value, const Material& material) {
  return {value, material.color, material.opacity, material.reflectivity, true};
}

// The numbers of the visible surfaces, as short as they can be read back.
template <class Number> std::string list(const Session& session, Number number) {
  std::vector<std::string> words;
  for (const IsoSurface& surface : session.surfaces)
    if (surface.visible) words.push_back(fmt::format("{}", number(surface)));
  return fmt::format("{}", fmt::join(words, ","));
}

// The palette's colours of as many surfaces as are visible.
std::string default_colors(const Session& session) {
  std::size_t i = 0;
  return list(session, [&](const IsoSurface&) { return hex_of(material_of({}, i++).color); });
}

std::string vector_text(const Double3& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

}  // namespace

std::string hex_of(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb_code(color[0]), srgb_code(color[1]), srgb_code(color[2]));
}

Session start_session(const RenderWords& words) {
  Session session{words, {}, {}, {}};
  const MaterialDescription looks = describe_materials(words);
  const std::vector<double> values =
      words.iso.empty() ? std::vector<double>() : parse_numbers(words.iso, "--iso");
  adopt_surfaces(session, values, materials_of(looks, values.size()));
  return session;
}

void adopt_surfaces(Session& session, const std::vector<double>& values,
                    const std::vector<Material>& materials) {
  session.surfaces.clear();
  for (std::size_t i = 0; i < values.size() && i < materials.size(); ++i)
    session.surfaces.push_back(surface_of(values[i], materials[i]));
  session.adopted = session.surfaces;
}

void add_surface(Session& session, double value) {
  session.surfaces.push_back(surface_of(value, material_of({}, session.surfaces.size())));
}

RenderWords words_of(const Session& session, int width, int height) {
  RenderWords words = session.words;
  words.size = fmt::format("{}x{}", width, height);
  if (session.camera) {
    const Camera& camera = *session.camera;
    words.position = vector_text(camera.position);
    words.target = vector_text(camera.target);
    words.up = vector_text(camera.up);
    words.fov = camera.ortho_height ? "" : fmt::format("{}", camera.fov);
    words.ortho = camera.ortho_height ? fmt::format("{}", *camera.ortho_height) : "";
  }
  if (session.surfaces == session.adopted) return words;
  if (std::ranges::none_of(session.surfaces, &IsoSurface::visible)) {  // an iso-value that nobody sees
    words.iso = fmt::format("{}", session.surfaces.front().value);
    words.colors.clear();
    words.reflectivity.clear();
    words.opacity.assign(1, '0');
    return words;
  }
  words.iso = list(session, [](const IsoSurface& s) { return s.value; });
  if (session.words.by_component) return words;
  words.colors = list(session, [](const IsoSurface& s) { return hex_of(s.color); });
  words.opacity = list(session, [](const IsoSurface& s) { return s.opacity; });
  words.reflectivity = list(session, [](const IsoSurface& s) { return s.reflectivity; });
  const auto any = [&](auto unusual) { return std::ranges::any_of(session.surfaces, unusual); };
  if (!any([](const IsoSurface& s) { return s.visible && s.opacity != 1; })) words.opacity.clear();
  if (!any([](const IsoSurface& s) { return s.visible && s.reflectivity != 0; })) words.reflectivity.clear();
  if (words.colors == default_colors(session)) words.colors.clear();
  return words;
}

}  // namespace isocast::viewer
