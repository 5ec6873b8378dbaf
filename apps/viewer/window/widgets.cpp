#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/base/error.h>

#include <optional>

namespace isocast::viewer {
namespace {

std::optional<double> number_in(const std::string& text) {
  try {
    return parse_number(text, "");
  } catch (const InputError&) { return std::nullopt; }
}

void line(const std::string& text, bool warning) {
  if (warning) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.55f, 0.4f, 1));
  ImGui::TextUnformatted(text.c_str());
  if (warning) ImGui::PopStyleColor();
}

}  // namespace

bool number_field(App& app, const char* name, double& value, float width) {
  const std::string id = fmt::format("##{}", name);
  std::string& text = app.fields[name];
  if (app.editing != name) {
    text = fmt::format("{}", value);
    if (ImGui::CalcTextSize(text.c_str()).x > width - 2 * ImGui::GetStyle().FramePadding.x)
      text = fmt::format("{:.5g}", value);
  }
  ImGui::SetNextItemWidth(width);
  ImGui::InputText(id.c_str(), &text,
                   ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
  app.landmarks.mark(name);
  if (ImGui::IsItemActive()) app.editing = name;
  else if (app.editing == name) app.editing.clear();
  if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
  const std::optional<double> typed = number_in(text);
  if (!typed || *typed == value) return false;
  value = *typed;
  return true;
}

bool text_field(App& app, const char* name, TypedText& typed, const std::string& source, const char* hint,
                bool now) {
  if (typed.agreed != source) typed.text = typed.agreed = source;
  ImGui::SetNextItemWidth(rest_of_width(0));
  const bool entered = ImGui::InputTextWithHint(fmt::format("##{}", name).c_str(), hint, &typed.text,
                                                now ? 0 : ImGuiInputTextFlags_EnterReturnsTrue);
  app.landmarks.mark(name);
  if (!entered || typed.text == typed.agreed) return false;
  typed.agreed = typed.text;
  return true;
}

bool choice(App& app, const char* name, const std::vector<std::string>& names, std::string& chosen) {
  bool changed = false;
  const bool open =
      ImGui::BeginCombo(fmt::format("##{}", name).c_str(), chosen.c_str(), ImGuiComboFlags_HeightLargest);
  app.landmarks.mark(name);
  if (!open) return false;
  for (const std::string& one : names) {
    if (ImGui::Selectable(one.c_str(), one == chosen)) {
      changed = one != chosen;
      chosen = one;
    }
    app.landmarks.mark(fmt::format("{}.{}", name, one));
  }
  ImGui::EndCombo();
  return changed;
}

bool button(App& app, const char* name, const char* label) {
  const bool pressed = ImGui::Button(fmt::format("{}##{}", label, name).c_str());
  app.landmarks.mark(name);
  return pressed;
}

bool check_box(App& app, const char* name, const char* label, bool& value) {
  const bool changed = ImGui::Checkbox(fmt::format("{}##{}", label, name).c_str(), &value);
  app.landmarks.mark(name);
  return changed;
}

float rest_of_width(float reserved) {
  return ImGui::GetContentRegionAvail().x - reserved * ImGui::GetFontSize();
}

void wrapped(const std::string& text, bool warning) {
  ImGui::PushTextWrapPos(0);
  line(text, warning);
  ImGui::PopTextWrapPos();
}

void shortened(std::string text, bool warning) {
  const auto width = [](const std::string& part) { return ImGui::CalcTextSize(part.c_str()).x; };
  const float room = ImGui::GetContentRegionAvail().x;
  if (width(text) > room) {
    while (!text.empty() && width(text + "...") > room) text.pop_back();
    text += "...";
  }
  line(text, warning);
}

}  // namespace isocast::viewer
