#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/viewer/formula_names.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// A text field that follows `source` until somebody types; `now`: take every letter over.
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

// The error under the formula, with a mark below the column that it names.
void formula_error(const App& app) {
  if (app.news->error.empty()) return;
  wrapped(app.news->error, true);
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
  const double before = value, reach = std::max(2 * std::abs(parameter.value), 1.0);
  ImGui::PushID(parameter.name.c_str());
  const double lo = -reach, hi = reach;
  ImGui::SetNextItemWidth(rest_of_width(9.5f));
  ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &lo, &hi, "");
  ImGui::SameLine();
  number_field(app, ("param." + parameter.name).c_str(), value, 4.5f * ImGui::GetFontSize());
  ImGui::SameLine();
  ImGui::TextUnformatted(parameter.name.c_str());
  ImGui::PopID();
  if (value != before) set_parameter(app.session.words, parameter.name, value);
}

void time_row(App& app) {
  RenderWords& words = app.session.words;
  double time = words.time.empty() ? 0 : parse_number(words.time, "--time");
  const double before = time, lo = 0, hi = std::max(1.0, std::ceil(time));
  if (button(app, "formula.play", app.playing ? "Stop" : "Play")) app.playing = !app.playing;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(rest_of_width(9));
  ImGui::SliderScalar("##time", ImGuiDataType_Double, &time, &lo, &hi, "");
  ImGui::SameLine();
  number_field(app, "time.value", time, 4.5f * ImGui::GetFontSize());
  ImGui::SameLine();
  ImGui::TextUnformatted("w");
  if (app.playing) time = std::fmod(time + app.play_speed * ImGui::GetIO().DeltaTime, 1.0);
  if (time != before) words.time = fmt::format("{}", time);
}

}  // namespace

void input_panel(App& app) {
  RenderWords& words = app.session.words;
  if (app.news->is_volume || is_scene_file(words.input) || has_volume_extension(words.input)) {
    if (text_field(app, "input.path", app.path, words.input, "a file, a formula or @id", false))
      app.open(app.path.text);
    if (app.news->objects > 1) wrapped(fmt::format("{} objects", app.news->objects));
    if (app.news->is_volume)
      wrapped(fmt::format("{} samples, {:.1f} MB", app.news->type,
                          1e-6 * static_cast<double>(app.news->volume_bytes)));
    return formula_error(app);
  }
  // only the surface changes, so that iso-value and camera stay
  if (text_field(app, "formula.text", app.formula, typed_formula(words.input), "f(x,y,z), @id or a file",
                 true)) {
    words.input = app.formula.text;
    if (is_volume_file(words.input, {})) app.open(words.input);
    if (words.input.starts_with('@')) words.params.clear();  // it has its own
  }
  formula_error(app);
  if (text_field(app, "input.domain", app.domain, words.domain, "domain: -1,1 or six numbers", false))
    words.domain = app.domain.text;
  const std::vector<NamedNumber> parameters = parameters_of(words);
  for (const NamedNumber& parameter : parameters) parameter_row(app, parameter);
  if (uses_time(words)) time_row(app);
}

}  // namespace isocast::viewer
