#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/extras.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// A range of decades that holds all positive values.
struct Decades {
  double lo = 1e300, hi = -1e300;
  void add(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    lo = std::min(lo, std::floor(std::log10(value)));
    hi = std::max(hi, std::ceil(std::log10(value)));
  }
  void finish() {
    if (lo > hi) lo = -8, hi = 0;
    if (lo == hi) ++hi;
  }
  [[nodiscard]] float share(double value) const {
    return static_cast<float>(std::clamp((std::log10(std::max(value, 1e-300)) - lo) / (hi - lo), 0.0, 1.0));
  }
};

}  // namespace

void draw_points(App& app) {
  const auto points = app.loop.idle().points.load();
  if (!points || points->empty()) return wrapped("being measured");
  Decades times, errors;
  for (const MethodPoint& point : *points) times.add(point.ms_per_megaray), errors.add(point.error);
  times.finish(), errors.finish();
  const float em = ImGui::GetFontSize(), width = rest_of_width(0), height = 9 * em;
  const ImVec2 corner = ImGui::GetCursorScreenPos(), end = {corner.x + width, corner.y + height};
  ImGui::InvisibleButton("points", {width, height});
  app.landmarks.mark("sure.plot");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, end, IM_COL32(24, 25, 28, 255), 3);
  const float margin = 0.5f * em;
  const MethodPoint* near = nullptr;
  float nearest = 1.5f * em;
  for (const MethodPoint& point : *points) {
    const float x = corner.x + margin + times.share(point.ms_per_megaray) * (width - 2 * margin),
                y = end.y - margin -
                    errors.share(std::isnan(point.error) ? 0 : point.error) * (height - 2 * margin);
    const bool used = point.method == app.object_news().method, wrong = point.wrong > 0;
    list.AddCircleFilled({x, y}, used ? 0.4f * em : 0.28f * em,
                         wrong  ? IM_COL32(230, 90, 70, 255)
                         : used ? IM_COL32(255, 200, 60, 255)
                                : IM_COL32(120, 170, 230, 255));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const float away = std::hypot(mouse.x - x, mouse.y - y);
    if (away < nearest) nearest = away, near = &point;
  }
  ImGui::TextUnformatted(
      fmt::format("time 1e{:.0f} to 1e{:.0f} ms a million rays", times.lo, times.hi).c_str());
  ImGui::TextUnformatted(fmt::format("median error 1e{:.0f} to 1e{:.0f}", errors.lo, errors.hi).c_str());
  if (near)
    ImGui::SetTooltip("%s", fmt::format("{}: {:.3g} ms, error {:.2g}, wrong {} of {}", near->method,
                                        near->ms_per_megaray, near->error, near->wrong, near->known)
                                .c_str());
  if (!ImGui::TreeNode("Table")) return;
  for (const MethodPoint& point : *points)
    ImGui::TextUnformatted(fmt::format("{}: {:.3g} ms, {:.2g}, wrong {} of {}", point.method,
                                       point.ms_per_megaray, point.error, point.wrong, point.known)
                               .c_str());
  ImGui::TreePop();
}

}  // namespace isocast::viewer
