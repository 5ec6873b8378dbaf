#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/iso_choices.h>
#include <isocast/apps/viewer/window/panels.h>

namespace isocast::viewer {
namespace {

// A surface's eye, value, colour and opacity; false: it was removed.
bool surface_row(App& app, std::size_t i) {
  SessionObject& object = app.session.object();
  IsoSurface& surface = object.surfaces[i];
  const float em = ImGui::GetFontSize();
  const std::string suffix = i == 0 ? "" : fmt::format("{}", i);
  ImGui::PushID(static_cast<int>(i));
  check_box(app, ("iso.eye" + suffix).c_str(), "", surface.visible);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("seen or not");
  ImGui::SameLine();
  if (object.has_iso()) {
    number_field(app, ("iso.value" + suffix).c_str(), surface.value, rest_of_width(9.4f));
    ImGui::SameLine();
  }
  const std::string hex = hex_of(surface.color);
  float color[3];
  for (int c = 0; c < 3; ++c)
    color[c] =
        static_cast<float>(std::stoul(hex.substr(1 + 2 * static_cast<std::size_t>(c), 2), nullptr, 16)) / 255;
  if (ImGui::ColorEdit3("##color", color, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel))
    surface.color = color_from_hex(fmt::format("#{:02x}{:02x}{:02x}", int(color[0] * 255 + 0.5f),
                                               int(color[1] * 255 + 0.5f), int(color[2] * 255 + 0.5f)));
  app.landmarks.mark("iso.color" + suffix);
  ImGui::SameLine();
  auto opacity = static_cast<float>(surface.opacity);
  ImGui::SetNextItemWidth(4.2f * em);
  if (ImGui::SliderFloat("##opacity", &opacity, 0, 1, "%.2f")) surface.opacity = opacity;
  app.landmarks.mark("iso.opacity" + suffix);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("opacity");
  bool keep = true;
  if (object.has_iso()) {
    ImGui::SameLine();
    keep = !button(app, ("iso.remove" + suffix).c_str(), "x") || object.surfaces.size() == 1;
  }
  ImGui::PopID();
  return keep;
}

void suggestions(App& app, const VolumeStatistics& statistics) {
  std::vector<std::string> names;
  const std::vector<IsoChoice> choices = iso_choices(statistics);
  for (const IsoChoice& one : choices) names.push_back(fmt::format("{}: {:.6g}", one.name, one.value));
  std::string chosen = "Suggestions";
  ImGui::SetNextItemWidth(rest_of_width(0));
  double& value = app.session.object().surfaces.front().value;
  if (choice(app, "iso.suggestions", names, chosen))
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == chosen) value = choices[i].value;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Enclose");
  ImGui::SameLine();
  if (number_field(app, "iso.enclose", app.enclosed, 4 * ImGui::GetFontSize()))
    value = enclosing_iso(statistics.histogram, app.enclosed);
  ImGui::SameLine();
  ImGui::TextUnformatted("% of the samples");
}

}  // namespace

void iso_panel(App& app) {
  SessionObject& object = app.session.object();
  if (object.surfaces.empty()) return wrapped(object.visible ? "not known yet" : "hidden");
  if (object.has_iso()) iso_slider(app);
  for (std::size_t i = 0; i < object.surfaces.size(); ++i)
    if (!surface_row(app, i)) {
      object.surfaces.erase(object.surfaces.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  if (!object.has_iso()) return;
  constexpr std::size_t kMost = 8;
  if (object.surfaces.size() < kMost && button(app, "iso.add", "Add an iso-value"))
    add_surface(object, object.surfaces.back().value);
  if (const auto statistics = app.statistics()) suggestions(app, *statistics);
}

}  // namespace isocast::viewer
