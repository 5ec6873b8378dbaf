#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/window/panels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast::viewer {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Angles {
  double azimuth, elevation;  // degrees
};
Angles angles_of(const std::string& light) {
  const std::vector<double> v = parse_numbers(light, "--light");
  return {std::atan2(v[1], v[0]) / kDegree, std::atan2(v[2], std::hypot(v[0], v[1])) / kDegree};
}
std::string light_of(const Angles& angles) {
  const double a = angles.azimuth * kDegree, e = angles.elevation * kDegree;
  return fmt::format("{:.6g},{:.6g},{:.6g}", std::cos(a) * std::cos(e), std::sin(a) * std::cos(e),
                     std::sin(e));
}

bool angle_slider(App& app, const std::string& name, const char* label, double& value, double reach) {
  const double lo = -reach, hi = reach;
  ImGui::SetNextItemWidth(0.5f * rest_of_width(3.5f));
  const bool moved = ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &lo, &hi, "%.0f\xc2\xb0");
  app.landmarks.mark(name);
  return moved;
}

// Direction of a light; false: it was removed.
bool light_row(App& app, std::size_t i) {
  Angles angles = angles_of(app.session.words.lights[i]);
  const std::string name = fmt::format("look.light{}", i);
  ImGui::PushID(static_cast<int>(i));
  const bool turned = angle_slider(app, name + ".azimuth", "##azimuth", angles.azimuth, 180);
  ImGui::SameLine();
  const bool raised = angle_slider(app, name + ".elevation", "##elevation", angles.elevation, 90);
  if (turned || raised) app.session.words.lights[i] = light_of(angles);
  ImGui::SameLine();
  const bool keep = !button(app, (name + ".remove").c_str(), "x");
  ImGui::PopID();
  return keep;
}

// A number that is not given until it is changed.
void count_slider(const char* label, std::optional<int>& value, int otherwise, int lo, int hi) {
  int now = value.value_or(otherwise);
  if (ImGui::SliderInt(label, &now, lo, hi)) value = now;
}

// What `--aa` has for the scene: most of it is for formulas.
std::vector<std::string> ways_of_edges(const App& app) {
  std::vector<std::string> ways = {"as they are", "samples"};
  const std::vector<SessionObject>& objects = app.session.objects;
  const bool formulas = std::ranges::all_of(objects, &SessionObject::is_formula);
  if (formulas) ways.emplace_back("silhouettes");
  if (formulas && objects.size() == 1) ways.emplace_back("shares");
  return ways;
}

}  // namespace

void look_panel(App& app) {
  RenderWords& words = app.session.words;
  for (std::size_t i = 0; i < words.lights.size(); ++i)
    if (!light_row(app, i)) words.lights.erase(words.lights.begin() + static_cast<std::ptrdiff_t>(i--));
  if (words.lights.empty()) wrapped("a headlight");
  constexpr std::size_t kMost = 8;
  if (words.lights.size() < kMost && button(app, "look.add", "Add a light"))
    words.lights.push_back(light_of({-60, 50}));
  check_box(app, "look.shadows", "Shadows", words.shadows);
  ImGui::SetNextItemWidth(rest_of_width(6));
  ImGui::SliderInt("occlusion", &words.ambient_occlusion, 0, 64);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("rays for the light of the sky at each hit");
  auto mirrored = app.session.object().surfaces.empty()
                      ? 0.0f
                      : static_cast<float>(app.session.object().surfaces.front().reflectivity);
  ImGui::SetNextItemWidth(rest_of_width(6));
  if (ImGui::SliderFloat("mirrored", &mirrored, 0, 1, "%.2f"))
    for (IsoSurface& surface : app.session.object().surfaces) surface.reflectivity = mirrored;
  app.landmarks.mark("look.mirrored");
  ImGui::SetNextItemWidth(rest_of_width(6));
  count_slider("reflections", words.reflections, 1, 0, 16);
  ImGui::SetNextItemWidth(rest_of_width(6));
  count_slider("crossings", words.transparency_depth, 4, 1, 64);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("that a ray passes through transparent surfaces");

  std::string edges = words.aa == "spp" || words.spp.value_or(1) > 1 ? "samples"
                      : words.aa == "silhouette"                     ? "silhouettes"
                      : words.aa == "coverage"                       ? "shares"
                                                                     : "as they are";
  ImGui::SetNextItemWidth(rest_of_width(6));
  if (choice(app, "look.edges", ways_of_edges(app), edges)) {
    words.aa = edges == "samples"       ? "spp"
               : edges == "silhouettes" ? "silhouette"
               : edges == "shares"      ? "coverage"
                                        : "";
    words.spp.reset();
  }
  ImGui::SameLine();
  ImGui::TextUnformatted("edges");
  if (edges == "samples") {
    ImGui::SetNextItemWidth(rest_of_width(6));
    count_slider("a pixel", words.spp, 4, 2, 64);
  }
  ImGui::SetNextItemWidth(rest_of_width(6));
  choice(app, "look.normals",
         app.object_news().is_volume ? std::vector<std::string>{"gradient", "difference"}
                                     : std::vector<std::string>{"gradient", "difference", "neighbour"},
         words.normals);
  ImGui::SameLine();
  ImGui::TextUnformatted("normals");
}

void clip_panel(App& app) {
  for (std::size_t i = 0; i < app.planes.size(); ++i) {
    ClipPlane& plane = app.planes[i];
    ImGui::PushID(static_cast<int>(i));
    const std::string name = fmt::format("clip.plane{}", i);
    check_box(app, (name + ".on").c_str(), "", plane.on);
    ImGui::SameLine();
    std::string side = fmt::format("{} {}", "xyz"[plane.axis], plane.above ? "above" : "below");
    ImGui::SetNextItemWidth(5.5f * ImGui::GetFontSize());
    if (choice(app, (name + ".side").c_str(),
               {"x below", "x above", "y below", "y above", "z below", "z above"}, side)) {
      plane.axis = side[0] - 'x';
      plane.above = side.ends_with("above");
    }
    ImGui::SameLine();
    const double lo = 0, hi = 1;
    ImGui::SetNextItemWidth(rest_of_width(2));
    ImGui::SliderScalar("##place", ImGuiDataType_Double, &plane.place, &lo, &hi, "%.3f");
    app.landmarks.mark(name + ".place");
    ImGui::SameLine();
    const bool remove = button(app, (name + ".remove").c_str(), "x");
    ImGui::PopID();
    if (remove) app.planes.erase(app.planes.begin() + static_cast<std::ptrdiff_t>(i--));
  }
  constexpr std::size_t kMost = 6;
  if (app.planes.size() < kMost && button(app, "clip.add", "Add a plane")) app.planes.emplace_back();
}

}  // namespace isocast::viewer
