#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// The values that the slider reaches: the volume's, or around those of a formula.
std::array<double, 2> range_of(const App& app, const VolumeStatistics* statistics) {
  if (statistics && statistics->min < statistics->max) return {statistics->min, statistics->max};
  return {-app.iso_reach, app.iso_reach};
}

ImU32 color_of(const IsoSurface& surface, float alpha) {
  const std::string hex = hex_of(surface.color);
  const auto code = std::stoul(hex.substr(1), nullptr, 16);
  return IM_COL32(code >> 16, code >> 8 & 255, code & 255, static_cast<int>(255 * alpha));
}

void draw_bars(const Histogram& histogram, ImVec2 lo, ImVec2 hi) {
  std::int64_t most = 1;
  for (const std::int64_t count : histogram.counts) most = std::max(most, count);
  const float step = (hi.x - lo.x) / Histogram::kBins;
  for (int bin = 0; bin < Histogram::kBins; ++bin) {
    const auto count = static_cast<double>(histogram.counts[static_cast<std::size_t>(bin)]);
    if (count <= 0) continue;
    const auto share =
        static_cast<float>((0.3 + std::log(count)) / (0.3 + std::log(static_cast<double>(most))));
    const float x = lo.x + step * static_cast<float>(bin);
    ImGui::GetWindowDrawList()->AddRectFilled({x, hi.y - share * (hi.y - lo.y)},
                                              {x + std::max(step, 1.0f), hi.y}, IM_COL32(110, 125, 150, 255));
  }
}

}  // namespace

bool iso_slider(App& app) {
  const auto statistics = app.statistics();
  if (!ImGui::IsMouseDown(0))  // of a formula; it stays while something is dragged
    for (const IsoSurface& surface : app.session.object().surfaces)
      app.iso_reach = std::max(app.iso_reach, 2 * std::abs(surface.value));
  const auto [lo, hi] = range_of(app, statistics.get());
  const float height = 6 * ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos(), end = {corner.x + width, corner.y + height};
  ImGui::InvisibleButton("slider", {width, height});
  app.landmarks.mark("iso.slider");
  app.landmarks.mark("iso.range", {lo, 0, hi, 0});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, end, IM_COL32(24, 25, 28, 255), 3);
  if (statistics) draw_bars(statistics->histogram, corner, end);

  std::vector<IsoSurface>& surfaces = app.session.object().surfaces;
  const auto place_of = [&](double value) {
    return corner.x + static_cast<float>((value - lo) / (hi - lo)) * width;
  };
  const ImGuiIO& io = ImGui::GetIO();
  bool moved = false;
  const auto move = [&](int i, double value) {
    double& now = surfaces[static_cast<std::size_t>(i)].value;
    moved = moved || now != value;
    now = value;
  };
  // the handle next to the mouse
  if (ImGui::IsItemActivated() && !surfaces.empty()) {
    const auto near = std::ranges::min_element(surfaces, {}, [&](const IsoSurface& surface) {
      return std::abs(place_of(surface.value) - io.MousePos.x);
    });
    app.dragged_iso = static_cast<int>(near - surfaces.begin());
  }
  const int last = static_cast<int>(surfaces.size()) - 1;
  const int chosen = std::clamp(app.dragged_iso, 0, std::max(last, 0));
  if (ImGui::IsItemActive() && last >= 0)
    move(chosen, std::clamp(lo + (io.MousePos.x - corner.x) / width * (hi - lo), lo, hi));
  else if (!ImGui::IsItemActive()) app.dragged_iso = last >= 0 && app.dragged_iso >= 0 ? chosen : -1;
  if (ImGui::IsItemHovered() && last >= 0) {
    const double fine = (hi - lo) / (io.KeyShift ? 10000 : 500);
    double& value = surfaces[static_cast<std::size_t>(chosen)].value;
    double steps = io.MouseWheel;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_LeftArrow))) --steps;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_RightArrow))) ++steps;
    if (steps != 0) move(chosen, std::clamp(value + steps * fine, lo, hi));
    ImGui::SetTooltip("drag; arrow keys and wheel step, with Shift finer");
  }
  if (last >= 0) {
    const float x = place_of(surfaces.front().value);
    app.landmarks.mark("iso.handle", {x, corner.y, x, end.y});
  }
  for (int i = 0; i <= last; ++i) {
    const IsoSurface& surface = surfaces[static_cast<std::size_t>(i)];
    const float x = place_of(surface.value), r = 0.35f * ImGui::GetFontSize();
    list.AddLine({x, corner.y}, {x, end.y}, color_of(surface, surface.visible ? 1.0f : 0.4f), 2);
    list.AddCircleFilled({x, end.y - r}, r, color_of(surface, surface.visible ? 1.0f : 0.4f));
    if (i == chosen) list.AddCircle({x, end.y - r}, r + 1, IM_COL32_WHITE);
  }
  return moved;
}

}  // namespace isocast::viewer
