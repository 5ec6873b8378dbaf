#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>

namespace isocast::viewer {
namespace {

const std::vector<std::string> kOverlays = {"none", "certificate", "cost", "error", "difference"};

void legend(const App& app) {
  switch (app.overlay) {
    case Overlay::certificate:
      if (!app.news->proves) return wrapped("this method proves nothing", true);
      return wrapped("green: a proved hit; blue: a proved miss; red: undecided");
    case Overlay::cost:
      return wrapped("from dark to bright: cells and cubics, or evaluations of the formula");
    case Overlay::error:
      return wrapped(
          "from dark (1e-8) to bright (1) voxels or domain widths; red: a false hit or miss; grey: unknown");
    case Overlay::difference: return wrapped("left: the method in use; right: the other one");
    default: return;
  }
}

}  // namespace

void sureness_panel(App& app) {
  std::string chosen = kOverlays[static_cast<std::size_t>(app.overlay)];
  ImGui::SetNextItemWidth(rest_of_width(4.5f));
  if (choice(app, "sure.overlay", kOverlays, chosen))
    app.overlay = static_cast<Overlay>(std::ranges::find(kOverlays, chosen) - kOverlays.begin());
  ImGui::SameLine();
  ImGui::TextUnformatted("overlay");
  const std::vector<std::string>& methods = app.object_news().methods;
  if (app.overlay == Overlay::difference && !methods.empty()) {
    if (std::ranges::find(methods, app.other_method) == methods.end()) app.other_method = methods.front();
    ImGui::SetNextItemWidth(rest_of_width(4.5f));
    choice(app, "sure.other", methods, app.other_method);
    ImGui::SameLine();
    ImGui::TextUnformatted("other");
  }
  legend(app);
  check_box(app, "sure.points", "Error against time of every method", app.points);
  if (app.points) draw_points(app);
  wrapped("A click on the picture probes its ray.");
}

void output_panel(App& app) {
  ImGui::SetNextItemWidth(rest_of_width(4.5f));
  ImGui::InputText("##file", &app.output);
  app.landmarks.mark("output.file");
  ImGui::SameLine();
  if (button(app, "output.save", "Save")) app.save(app.output);
  if (button(app, "output.copy", "Copy the command line")) app.copy_command();
  if (!app.message.empty()) wrapped(app.message);
}

}  // namespace isocast::viewer
