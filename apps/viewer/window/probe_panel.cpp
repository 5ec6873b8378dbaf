#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

const char* name_of(Certificate certificate) {
  switch (certificate) {
    case Certificate::proved_hit: return "proved hit";
    case Certificate::proved_miss: return "proved miss";
    case Certificate::undecided: return "undecided";
    default: return "no proof";
  }
}

void draw_table(const PixelProbe& probe) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                    ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("answers", 8, flags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* title : {"method", "precision", "t", "bracket", "proof", "error", "seconds", "verdict"})
    ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  for (const ProbeAnswer& a : probe.probe.answers) {
    const bool hit = std::isfinite(a.t);
    ImGui::TableNextRow();
    cell(a.method);
    cell(a.precision);
    cell(hit ? fmt::format("{:.12g}", a.t) : "no hit");
    cell(hit ? fmt::format("{:.2g}", a.t_hi - a.t_lo) : "");
    cell(name_of(a.certificate));
    cell(std::isnan(a.error) ? "" : fmt::format("{:.2g}", a.error));
    cell(fmt::format("{:.2g}", a.seconds));
    cell(std::string(a.verdict) + (a.contradiction.empty() ? "" : ", CONTRADICTED"));
  }
  ImGui::EndTable();
}

}  // namespace

// The part of the ray around the first root that `profile_zoom` leaves.
void draw_profile(App& app, const PixelProbe& probe) {
  const RayProfile& profile = probe.profile;
  const ImVec2 corner = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  if (profile.values.empty() || room.x < 10 || room.y < 10)
    return wrapped("The ray passes beside the domain.");
  const ImVec2 end = {corner.x + room.x, corner.y + room.y};
  ImGui::InvisibleButton("profile", room);
  app.landmarks.mark("probe.plot");
  if (ImGui::IsItemHovered()) {
    app.profile_zoom = std::clamp(app.profile_zoom * std::pow(1.25, ImGui::GetIO().MouseWheel), 1.0, 1e4);
    ImGui::SetTooltip(
        "f along the ray; blue: cell borders, orange: the iso-value, lines: roots; the wheel zooms");
  }
  const reference::RayRoot* const first = bench::first_crossing(probe.probe.truth);
  const double whole = profile.t1 - profile.t0, part = whole / app.profile_zoom,
               middle = first ? bench::middle(*first) : 0.5 * (profile.t0 + profile.t1);
  const double t0 = std::clamp(middle - 0.5 * part, profile.t0, profile.t1 - part), t1 = t0 + part;
  const auto steps = static_cast<double>(profile.values.size() - 1);
  const auto index = [&](double t) { return (t - profile.t0) / whole * steps; };

  // the range of the values in sight, with the iso-values
  float lo = INFINITY, hi = -INFINITY;
  const auto from = static_cast<std::size_t>(std::max(0.0, std::floor(index(t0)))),
             to = static_cast<std::size_t>(std::min(steps, std::ceil(index(t1))));
  for (std::size_t i = from; i <= to; ++i)
    if (std::isfinite(profile.values[i]))
      lo = std::min(lo, profile.values[i]), hi = std::max(hi, profile.values[i]);
  for (const double iso : probe.iso)
    lo = std::min(lo, static_cast<float>(iso)), hi = std::max(hi, static_cast<float>(iso));
  if (!(lo < hi)) lo -= 1, hi += 1;
  const auto x_of = [&](double t) { return corner.x + static_cast<float>((t - t0) / part) * room.x; };
  const auto y_of = [&](double f) { return end.y - (static_cast<float>(f) - lo) / (hi - lo) * room.y; };

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, end, IM_COL32(24, 25, 28, 255), 3);
  list.PushClipRect(corner, end, true);
  constexpr std::ptrdiff_t kMostBorders = 200;
  const auto first_border = std::ranges::lower_bound(profile.borders, t0),
             last_border = std::ranges::upper_bound(profile.borders, t1);
  if (last_border - first_border <= kMostBorders)
    for (auto border = first_border; border != last_border; ++border)
      list.AddLine({x_of(*border), corner.y}, {x_of(*border), end.y}, IM_COL32(60, 75, 110, 255));
  for (const double iso : probe.iso)
    list.AddLine({corner.x, y_of(iso)}, {end.x, y_of(iso)}, IM_COL32(230, 150, 60, 255));
  for (std::size_t i = from; i < to; ++i) {
    const auto t_of = [&](std::size_t n) { return profile.t0 + static_cast<double>(n) / steps * whole; };
    if (std::isfinite(profile.values[i]) && std::isfinite(profile.values[i + 1]))
      list.AddLine({x_of(t_of(i)), y_of(profile.values[i])}, {x_of(t_of(i + 1)), y_of(profile.values[i + 1])},
                   IM_COL32(220, 220, 220, 255), 1.5f);
  }
  for (const reference::RayRoot& root : probe.probe.truth.roots)
    list.AddLine({x_of(bench::middle(root)), corner.y}, {x_of(bench::middle(root)), end.y},
                 IM_COL32(90, 200, 110, 160));
  int row = 0;
  for (const ProbeAnswer& answer : probe.probe.answers) {
    ++row;
    if (!std::isfinite(answer.t)) continue;
    const float x = x_of(answer.t), y = corner.y + 3 +
                                        static_cast<float>(row) /
                                            static_cast<float>(probe.probe.answers.size() + 1) * (room.y - 6);
    list.AddCircleFilled(
        {x, y}, 3, answer.verdict == "right" ? IM_COL32(90, 200, 110, 255) : IM_COL32(230, 80, 60, 255));
    if (ImGui::IsMouseHoveringRect({x - 4, y - 4}, {x + 4, y + 4}))
      ImGui::SetTooltip("%s", fmt::format("{} {}: t = {:.15g}, {}", answer.method, answer.precision, answer.t,
                                          answer.verdict)
                                  .c_str());
  }
  list.PopClipRect();
}

void draw_probe(App& app) {
  if (button(app, "probe.close", "Close")) app.probe_open = false;
  ImGui::SameLine();
  if (!app.probed) return ImGui::TextUnformatted("The ray is being solved by every method.");
  const PixelProbe& probe = *app.probed;
  const auto& truth = probe.probe.truth;
  const std::string where =
      fmt::format("pixel {}, {}{}{}", probe.x, probe.y, probe.object.empty() ? "" : ", ", probe.object);
  if (!probe.error.empty()) return wrapped(where + ": " + probe.error, true);
  wrapped(fmt::format("{}: {} root{} of the reference{}; errors in {}", where, truth.roots.size(),
                      truth.roots.size() == 1 ? "" : "s", truth.decided() ? "" : ", not decided everywhere",
                      probe.unit));
  app.landmarks.mark("probe.title");
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::BeginChild("table", {0.6f * width, 0});
  draw_table(probe);
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("plot", {0, 0});
  draw_profile(app, probe);
  ImGui::EndChild();
}

}  // namespace isocast::viewer
