#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <isocast/apps/viewer/window/panels.h>
#include <sys/resource.h>

namespace isocast::viewer {
namespace {

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::preview: return "preview";
    case Stage::coarse: return "coarse";
    case Stage::full: return "full";
    default: return "complete";
  }
}

double peak_memory_mb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

}  // namespace

void draw_status(App& app) {
  if (!app.news->error.empty()) {
    shortened(app.news->error, true);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", app.news->error.c_str());
    return;
  }
  if (!app.shown) return ImGui::TextUnformatted("no picture yet");
  const Picture& picture = *app.shown;
  const RenderCounts& counts = picture.counts;
  const auto rays =
      static_cast<double>(counts.primary + counts.shadow + counts.reflection + counts.transparency);
  std::string text =
      fmt::format("{} {} x {}  |  {:.1f} ms  |  {:.1f} Mrays/s  |  {}  |  {}  |  {:.0f} MB",
                  name_of(picture.stage), picture.width, picture.height, picture.ms,
                  rays / (1e3 * picture.ms), app.object_news().method, app.news->isa, peak_memory_mb());
  const std::string left_out = fmt::format("left out: {}", fmt::join(app.news->left_out, ", "));
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string both = text + "  |  " + left_out;
  shortened(ImGui::CalcTextSize(both.c_str()).x < room ? both : text);
  app.landmarks.mark("status.text");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", left_out.c_str());
}

void draw_loading(App& app) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, 0, {0.5f, 0.5f});
  ImGui::Begin("Loading", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings);
  const ProgressWatch::Work work = app.loop.work();
  ImGui::TextUnformatted(work.what.empty() ? "loading" : work.what.c_str());
  ImGui::ProgressBar(static_cast<float>(work.share), {20 * ImGui::GetFontSize(), 0});
  if (button(app, "loading.cancel", "Cancel")) app.loop.cancel();
  ImGui::End();
}

}  // namespace isocast::viewer
