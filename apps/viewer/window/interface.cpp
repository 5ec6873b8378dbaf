#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <isocast/apps/viewer/camera_motion.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>

namespace isocast::viewer {
namespace {

// A part of the window with a fixed place; those that others may cover stay behind.
bool begin_part(const char* name, float x, float y, float width, float height, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({std::max(width, 1.0f), std::max(height, 1.0f)});
  return ImGui::Begin(name, nullptr,
                      flags | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
}
constexpr ImGuiWindowFlags kBehind = ImGuiWindowFlags_NoBringToFrontOnFocus;

// A section of the panel under its header.
void section(App& app, const char* name, const char* title, bool open, void (*draw)(App&)) {
  const bool shown = ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  app.landmarks.mark(fmt::format("section.{}", name));
  if (!shown) return;
  ImGui::PushID(name);
  draw(app);
  ImGui::PopID();
  ImGui::Spacing();
}

void draw_panel(App& app) {
  section(app, "input", "Input", true, input_panel);
  if (app.session.objects.size() > 1) section(app, "objects", "Objects", true, objects_panel);
  section(app, "iso", app.session.object().has_iso() ? "Iso-values" : "Look", true, iso_panel);
  section(app, "method", "Method", true, method_panel);
  section(app, "camera", "Camera", true, camera_panel);
  section(app, "color", "Colour by another field", false, color_panel);
  section(app, "look", "Light and edges", false, look_panel);
  section(app, "clip", "Clip planes", false, clip_panel);
  section(app, "sure", "How sure it is", true, sureness_panel);
  section(app, "output", "Save", true, output_panel);
}

void change_camera(App& app, Camera (*change)(const Camera&, const App&)) {
  if (const std::optional<Camera> camera = app.camera()) app.session.camera = change(*camera, app);
}

void handle_keys(App& app) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
  if (io.KeyCtrl && pressed(GLFW_KEY_Q)) app.window.close();
  if (pressed(GLFW_KEY_F11)) app.window.toggle_full_screen();
  if (pressed(GLFW_KEY_ESCAPE) && ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup))
    ImGui::ClosePopupToLevel(0, true);
  if (io.WantTextInput) return;
  if (io.KeyCtrl && pressed(GLFW_KEY_S)) app.save(app.output);
  if (io.KeyCtrl && pressed(GLFW_KEY_C)) app.copy_command();
  if (io.KeyCtrl) return;
  if (pressed(GLFW_KEY_SPACE)) app.playing = !app.playing;
  if (pressed(GLFW_KEY_F) || pressed(GLFW_KEY_HOME))
    change_camera(app, [](const Camera& camera, const App& now) {
      const auto [width, height] = now.picture_size();
      return fit(camera, now.news->bounds, double(width) / height);
    });
  if (pressed(GLFW_KEY_P))
    change_camera(app, [](const Camera& camera, const App&) {
      return with_perspective(camera, camera.ortho_height.has_value());
    });
}

}  // namespace

void draw_interface(App& app) {
  const auto [w, h] = app.window.size();
  const auto s = static_cast<float>(app.window.scale());
  const float width = static_cast<float>(w), height = static_cast<float>(h);
  const float panel = std::min(340 * s, 0.5f * width), status = 26 * s;
  const float probe = app.probe_open ? std::min(0.45f * height, 330 * s) : 0;
  begin_part("panel", 0, 0, panel, height - status, kBehind);
  draw_panel(app);
  app.landmarks.mark("panel", {0, 0, panel, height - status});
  ImGui::End();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  begin_part("canvas", panel, 0, width - panel, height - status,
             kBehind | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                 ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  draw_canvas(app);
  ImGui::End();
  if (app.probe_open) {  // over the picture, which keeps its size
    begin_part("probe", panel, height - status - probe, width - panel, probe, 0);
    draw_probe(app);
    ImGui::End();
  }
  begin_part("status", 0, height - status, width, status, kBehind | ImGuiWindowFlags_NoScrollbar);
  draw_status(app);
  ImGui::End();
  if (app.loop.loading()) draw_loading(app);
  handle_keys(app);
}

}  // namespace isocast::viewer
