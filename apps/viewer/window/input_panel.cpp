#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/viewer/formula_names.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isocast::viewer {
namespace {

// The error of the newest wish. Of a formula, whose text begins at `corner`: with a mark at the column that
// it names.
void draw_error(const App& app, const ImVec2* corner) {
  const std::string& error = app.news->error;
  if (error.empty()) return;
  int line = 0, column = 0;
  const std::string text = typed_formula(app.session.words.input);
  if (corner && std::sscanf(error.c_str(), "formula:%d:%d:", &line, &column) == 2 && line == 1 &&
      column > 0) {
    const std::string before = text.substr(0, static_cast<std::size_t>(column - 1));
    const float em = ImGui::GetFontSize(),
                x = corner->x + ImGui::GetStyle().FramePadding.x + ImGui::CalcTextSize(before.c_str()).x,
                y = corner->y + ImGui::GetFrameHeight();
    ImGui::GetWindowDrawList()->AddTriangleFilled({x, y - 0.35f * em}, {x - 0.25f * em, y},
                                                  {x + 0.25f * em, y}, IM_COL32(255, 140, 100, 255));
  }
  wrapped(error, true);
}

double parameter_of(const RenderWords& words, const std::string& name, double otherwise) {
  for (const std::string& word : words.params)
    if (word.starts_with(name + "=")) return parse_number(word.substr(name.size() + 1), "--param");
  return otherwise;
}
void set_parameter(RenderWords& words, const std::string& name, double value) {
  std::erase_if(words.params, [&](const std::string& word) { return word.starts_with(name + "="); });
  words.params.push_back(fmt::format("{}={}", name, value));
}

// A slider with a number beside it.
void parameter_row(App& app, const NamedNumber& parameter) {
  double value = parameter_of(app.session.words, parameter.name, parameter.value);
  const double before = value;
  const auto reach = static_cast<float>(std::max(2 * std::abs(value), 1.0));
  ImGui::PushID(parameter.name.c_str());
  // a slider's ends follow the value, but not while it is dragged
  float& ends = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("ends"), reach);
  const double lo = -ends, hi = ends;
  ImGui::SetNextItemWidth(rest_of_width(9.5f));
  ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &lo, &hi, "");
  if (!ImGui::IsItemActive()) ends = reach;
  ImGui::SameLine();
  number_field(app, ("param." + parameter.name).c_str(), value, 4.5f * ImGui::GetFontSize());
  ImGui::SameLine();
  ImGui::TextUnformatted(parameter.name.c_str());
  ImGui::PopID();
  if (value != before) set_parameter(app.session.words, parameter.name, value);
}

}  // namespace

void input_panel(App& app) {
  RenderWords& words = app.session.words;
  const bool is_volume = app.session.object().type == "volume";
  if (is_volume || is_scene_file(words.input) || has_volume_extension(words.input)) {
    if (text_field(app, "input.path", app.path, words.input, "a file, a formula or @id", false))
      app.open(app.path.text);
    if (app.session.objects.size() > 1) wrapped(fmt::format("{} objects", app.session.objects.size()));
    else if (app.object_news().is_volume)
      wrapped(fmt::format("{} samples, {:.1f} MB", app.news->type,
                          1e-6 * static_cast<double>(app.news->volume_bytes)));
    time_rows(app);
    return draw_error(app, nullptr);
  }
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  // only the surface changes, so that iso-value and camera stay
  if (text_field(app, "formula.text", app.formula, typed_formula(words.input), "f(x,y,z), @id or a file",
                 true)) {
    words.input = app.formula.text;
    if (is_volume_file(words.input, {})) app.open(words.input);
    if (words.input.starts_with('@')) words.params.clear();  // it has its own
  }
  draw_error(app, &corner);
  if (text_field(app, "input.domain", app.domain, words.domain, "domain: -1,1 or six numbers", false))
    words.domain = app.domain.text;
  const std::vector<NamedNumber> parameters = parameters_of(words);
  for (const NamedNumber& parameter : parameters) parameter_row(app, parameter);
  time_rows(app);
}

}  // namespace isocast::viewer
