#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/camera_motion.h>
#include <isocast/apps/viewer/window/panels.h>

namespace isocast::viewer {
namespace {

// Starts a new row where the next button would be cut.
void same_line_if_room(const char* label) {
  const float width = ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
  if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <
      ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
    ImGui::SameLine();
}

}  // namespace

void camera_panel(App& app) {
  const std::optional<Camera> camera = app.camera();
  if (!camera) return wrapped("not known yet");
  const auto [width, height] = app.picture_size();
  if (button(app, "camera.fit", "Fit"))
    app.session.camera = fit(*camera, app.news->bounds, double(width) / height);
  for (const StandardView& view : standard_views()) {
    same_line_if_room(view.name);
    if (button(app, fmt::format("camera.{}", view.name).c_str(), view.name))
      app.session.camera = look_from(*camera, view);
  }
  bool perspective = !camera->ortho_height;
  if (check_box(app, "camera.perspective", "Perspective", perspective))
    app.session.camera = with_perspective(*camera, perspective);
  ImGui::SameLine();
  if (button(app, "camera.full", "Full screen")) app.window.toggle_full_screen();
  check_box(app, "camera.blender", "Middle button turns, as in Blender", app.blender_mouse);
  check_box(app, "camera.hold", "Hold full quality while dragging", app.hold_full);
}

}  // namespace isocast::viewer
