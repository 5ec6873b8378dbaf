#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/camera_motion.h>
#include <isocast/apps/viewer/window/opaque.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// Where the picture is on the screen: as it is, in the middle, or smaller where it does not fit.
struct Place {
  float x, y, width, height;
};
Place place_of(const App& app, ImVec2 corner, ImVec2 room) {
  const auto [w, h] = app.picture_size();
  const float width = static_cast<float>(w), height = static_cast<float>(h);
  const float factor = std::min({1.0f, room.x / width, room.y / height});
  return {corner.x + std::floor(0.5f * (room.x - factor * width)),
          corner.y + std::floor(0.5f * (room.y - factor * height)), factor * width, factor * height};
}

void draw_picture(App& app, const Place& place) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!app.shown) {  // a software OpenGL compiles for both kinds of textures when it first sees them: now
    begin_opaque(list);
    for (const Texture* const one : {&app.texture, &app.other_texture})
      list.AddImage(one->handle(), {place.x, place.y}, {place.x + 1, place.y + 1});
    return end_opaque(list);
  }
  // pixels of a preview may reach over the picture's edge to the left and right
  const float width = place.height * static_cast<float>(app.texture.width()) /
                      static_cast<float>(app.texture.height()),
              x = place.x + 0.5f * (place.width - width);
  list.PushClipRect({place.x, place.y}, {place.x + place.width, place.y + place.height}, true);
  begin_opaque(list);
  list.AddImage(app.texture.handle(), {x, place.y}, {x + width, place.y + place.height});
  const bool two = app.overlay == Overlay::difference && !app.shown->other.empty();
  const auto share = static_cast<float>(app.divider);
  const float at = place.x + share * place.width;
  if (two)
    list.AddImage(app.other_texture.handle(), {at, place.y}, {place.x + place.width, place.y + place.height},
                  {share, 0}, {1, 1});
  end_opaque(list);
  if (two) {
    list.AddLine({at, place.y}, {at, place.y + place.height}, IM_COL32(255, 200, 60, 255), 2);
    const float size = ImGui::GetFontSize();
    const ImVec2 extent = ImGui::CalcTextSize(app.object_news().method.c_str());
    list.AddText({at - extent.x - 0.5f * size, place.y + 0.4f * size}, IM_COL32(200, 110, 0, 255),
                 app.object_news().method.c_str());
    list.AddText({at + 0.5f * size, place.y + 0.4f * size}, IM_COL32(200, 110, 0, 255),
                 app.other_method.c_str());
  }
  list.PopClipRect();
}

enum class Motion : std::uint8_t { none, orbit, pan, zoom };

// ParaView: left turns, middle moves, right zooms; Blender: middle turns, with Shift it moves, with Ctrl it
// zooms, and left turns too.
Motion motion_of(const App& app) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool left = io.MouseDown[0], right = io.MouseDown[1], middle = io.MouseDown[2];
  if (app.blender_mouse && middle)
    return io.KeyShift ? Motion::pan : io.KeyCtrl ? Motion::zoom : Motion::orbit;
  if (middle || (left && io.KeyShift)) return Motion::pan;
  if (right || (left && io.KeyCtrl)) return Motion::zoom;
  return left ? Motion::orbit : Motion::none;
}

void move_camera(App& app, const Place& place) {
  const ImGuiIO& io = ImGui::GetIO();
  std::optional<Camera> camera = app.camera();
  if (!camera) return;
  const double dx = io.MouseDelta.x / place.height, dy = io.MouseDelta.y / place.height;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    app.session.camera = camera = zoom(*camera, io.MouseWheel);
  constexpr float kClick = 3;
  const bool dragging = ImGui::IsItemActive() && (dx != 0 || dy != 0) &&
                        (!io.MouseDown[0] || io.MouseDragMaxDistanceSqr[0] > kClick * kClick);
  if (!dragging) return;
  switch (motion_of(app)) {
    case Motion::orbit: app.session.camera = orbit(*camera, dx, dy); break;
    case Motion::pan: app.session.camera = pan(*camera, dx, dy); break;
    case Motion::zoom: app.session.camera = zoom(*camera, -20 * dy); break;
    default: break;
  }
}

// The divider of two methods, where the mouse is near it.
bool move_divider(App& app, const Place& place) {
  if (app.overlay != Overlay::difference) return false;
  const float at = place.x + static_cast<float>(app.divider) * place.width,
              reach = 0.5f * ImGui::GetFontSize();
  ImGui::SetCursorScreenPos({at - reach, place.y});
  ImGui::InvisibleButton("divider", {2 * reach, std::max(1.0f, place.height)});
  app.landmarks.mark("canvas.divider");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (!ImGui::IsItemActive()) return false;
  app.divider = std::clamp<double>((ImGui::GetIO().MousePos.x - place.x) / place.width, 0, 1);
  return true;
}

void probe_click(App& app, const Place& place) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr float kClick = 3;
  if (!ImGui::IsItemDeactivated() || !ImGui::IsMouseReleased(0) ||
      io.MouseDragMaxDistanceSqr[0] > kClick * kClick)
    return;
  const auto [width, height] = app.picture_size();
  const int x = static_cast<int>(
                std::floor((io.MousePos.x - place.x) / place.width * static_cast<float>(width))),
            y = static_cast<int>(
                std::floor((io.MousePos.y - place.y) / place.height * static_cast<float>(height)));
  if (x >= 0 && y >= 0 && x < width && y < height && app.news->any) app.probe(x, y);
}

}  // namespace

void draw_canvas(App& app) {
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  app.canvas = {static_cast<int>(room.x), static_cast<int>(room.y)};
  const Place place = place_of(app, corner, room);
  draw_picture(app, place);
  const bool divider = move_divider(app, place);
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("picture", room,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  app.landmarks.mark("canvas.picture", {place.x, place.y, place.x + place.width, place.y + place.height});
  if (divider) return;
  move_camera(app, place);
  probe_click(app, place);
}

}  // namespace isocast::viewer
