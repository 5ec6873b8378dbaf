#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/scene/color_map.h>

#include <algorithm>

namespace isocast::viewer {
namespace {

// As much of the text as there is room for.
std::string cut_to(const std::string& text, float room) {
  if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  std::size_t length = text.size();
  while (length > 0 && ImGui::CalcTextSize((text.substr(0, length) + "...").c_str()).x > room) --length;
  return text.substr(0, length) + "...";
}

}  // namespace

void objects_panel(App& app) {
  constexpr int kMostRows = 6;
  Session& session = app.session;
  const int rows = std::min(static_cast<int>(session.objects.size()), kMostRows);
  const float height = static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("list", {0, height});
  for (std::size_t k = 0; k < session.objects.size(); ++k) {
    SessionObject& object = session.objects[k];
    ImGui::PushID(static_cast<int>(k));
    check_box(app, fmt::format("objects.eye{}", k).c_str(), "", object.visible);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("seen or not");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string name = object.name.empty() ? fmt::format("number {}", k + 1) : object.name;
    const std::string row = fmt::format("{} ({})", name, object.type);
    const std::string shown = cut_to(row, rest_of_width(0));
    if (ImGui::Selectable(shown.c_str(), k == session.current)) session.current = k;
    if (shown != row && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", row.c_str());
    app.landmarks.mark(fmt::format("objects.{}", name));
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void color_panel(App& app) {
  ColorWords& words = app.session.object().color_by;
  if (text_field(app, "color.of", app.color_of, words.of, "a formula or a volume's file"))
    words.of = app.color_of.text;
  if (words.of.empty()) return wrapped("Each surface has its own colour.");
  const auto labelled = [](const char* label) {
    ImGui::SameLine();
    ImGui::TextUnformatted(label);
  };
  std::vector<std::string> maps = color_map_names();
  if (words.map.ends_with(".json")) maps.push_back(words.map);
  ImGui::SetNextItemWidth(rest_of_width(6));
  choice(app, "color.map", maps, words.map);
  labelled("map");
  if (text_field(app, "color.file", app.color_map, words.map.ends_with(".json") ? words.map : "",
                 "or a map of ParaView, .json"))
    words.map = app.color_map.text.ends_with(".json") ? app.color_map.text : "viridis";
  if (text_field(app, "color.range", app.color_range, words.range, "range: LO,HI (the field's own)"))
    words.range = app.color_range.text;
  check_box(app, "color.log", "Logarithmic", words.logarithmic);
}

}  // namespace isocast::viewer
