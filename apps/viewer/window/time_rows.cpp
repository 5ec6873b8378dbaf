#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/formula_names.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// A button that plays, a slider from lo to hi, the number that it stands at, and its name.
void row(App& app, const char* name, const char* label, double& value, double lo, double hi) {
  if (button(app, fmt::format("{}.play", name).c_str(), app.playing ? "Stop" : "Play"))
    app.playing = !app.playing;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(rest_of_width(9.5f));
  ImGui::SliderScalar(fmt::format("##{}", name).c_str(), ImGuiDataType_Double, &value, &lo, &hi, "");
  app.landmarks.mark(fmt::format("{}.slider", name));
  ImGui::SameLine();
  number_field(app, fmt::format("{}.value", name).c_str(), value, 4.5f * ImGui::GetFontSize());
  ImGui::SameLine();
  ImGui::TextUnformatted(label);
}

void time_row(App& app) {
  RenderWords& words = app.session.words;
  double time = 0;
  if (app.session.document) time = app.session.document->value("time", 0.0);
  if (!words.time.empty()) time = parse_number(words.time, "--time");
  const double before = time;
  row(app, "time", "w", time, 0, std::max(1.0, std::ceil(time)));
  constexpr double kPerSecond = 0.5;
  if (app.playing) time = std::fmod(time + kPerSecond * ImGui::GetIO().DeltaTime, 1.0);
  if (time != before) words.time = fmt::format("{}", time);
}

void frame_row(App& app, int first, int last) {
  const int before = app.session.frame.value_or(first);
  double frame = before;
  row(app, "frame", "frame", frame, first, last);
  constexpr double kPerSecond = 24;
  if (app.playing) {
    app.played_frames += kPerSecond * ImGui::GetIO().DeltaTime;
    frame += std::floor(app.played_frames);
    app.played_frames -= std::floor(app.played_frames);
    frame = first + std::fmod(frame - first, last - first + 1);
  }
  const int now = static_cast<int>(std::lround(std::clamp<double>(frame, first, last)));
  if (now != before) app.session.frame = now;
}

}  // namespace

void time_rows(App& app) {
  if (const auto frames = app.session.frames()) return frame_row(app, (*frames)[0], (*frames)[1]);
  if (uses_time(app.session)) time_row(app);
}

}  // namespace isocast::viewer
