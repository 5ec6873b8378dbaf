#include <fmt/format.h>
#include <isocast/apps/bench/plot.h>

namespace isocast::bench {
namespace {

constexpr const char* kStyle =
    "text{font-family:system-ui,sans-serif;fill:#333}.tick{font-size:12px;fill:#667}.name{font-size:13px}"
    ".key{font-size:13px}.end{text-anchor:end}.middle{text-anchor:middle}.grid{stroke:#e3e3e8}"
    ".sweep{fill:none;stroke-opacity:.5}.whisker{stroke-opacity:.35;stroke-width:2}"
    ".front{fill:none;stroke:#d9d2c0;stroke-width:8;stroke-linejoin:round;stroke-linecap:round}"
    ".dotted{stroke-dasharray:1 4}.front.dotted{stroke-dasharray:1 13}"
    ".mark:hover{stroke:#111;stroke-width:2.5}";

std::string number(double value) { return fmt::format("{:.1f}", value); }

std::string outline(const PlotMark& m) {
  const double r = m.radius, x = m.x, y = m.y;
  switch (m.shape) {
    case 0:
      return fmt::format("M{0:.1f} {1:.1f}a{2} {2} 0 1 0 {3} 0a{2} {2} 0 1 0 -{3} 0z", x - r, y, r, 2 * r);
    case 1: return fmt::format("M{:.1f} {:.1f}h{}v{}h-{}z", x - r, y - r, 2 * r, 2 * r, 2 * r);
    case 2: return fmt::format("M{:.1f} {:.1f}l{} {}h-{}z", x, y - 1.2 * r, 1.2 * r, 2.1 * r, 2.4 * r);
    default: return fmt::format("M{0:.1f} {1:.1f}l{2} {2}l-{2} {2}l-{2} -{2}z", x, y - 1.3 * r, 1.3 * r);
  }
}

}  // namespace

std::string method_color(std::size_t n) {
  static constexpr std::array colors = {"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9",
                                        "#7a5cc2", "#8a8a00", "#8c564b", "#3a7d44", "#b2182b", "#555555"};
  return colors[n % colors.size()];
}

Plot::Plot(std::string_view kind, double width, double height) {
  svg_.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                    {"viewBox", fmt::format("0 0 {} {}", width, height)},
                    {"class", std::string(kind)},
                    {"role", "img"}});
  svg_.open("style").append(kStyle).close();
}

void Plot::text(double x, double y, std::string_view kind, std::string_view words) {
  svg_.element("text", {{"x", number(x)}, {"y", number(y)}, {"class", std::string(kind)}}, words);
}

void Plot::upright(double x, double y, std::string_view words) {
  const std::string turn = fmt::format("translate({:.1f} {:.1f}) rotate(-90)", x, y);
  svg_.element("text", {{"transform", turn}, {"class", "name middle"}}, words);
}

void Plot::line(std::string_view kind, double x0, double y0, double x1, double y1, const std::string& color) {
  Attributes attributes = {{"class", std::string(kind)},
                           {"x1", number(x0)},
                           {"y1", number(y0)},
                           {"x2", number(x1)},
                           {"y2", number(y1)}};
  if (!color.empty()) attributes.emplace_back("stroke", color);
  svg_.element("line", attributes);
}

void Plot::join(const std::vector<std::array<double, 2>>& points, std::string_view kind,
                const std::string& color) {
  std::string list;
  for (const auto& [x, y] : points) list += fmt::format("{:.1f},{:.1f} ", x, y);
  svg_.element("polyline", {{"class", std::string(kind)}, {"points", list}, {"stroke", color}});
}

void Plot::mark(const PlotMark& mark, const std::string& title) {
  svg_.open("path", {{"class", "mark"},
                     {"d", outline(mark)},
                     {"fill", mark.hollow ? "#fff" : mark.color},
                     {"fill-opacity", mark.hollow ? "0.6" : "0.85"},
                     {"stroke", mark.hollow ? mark.color : "#fff"},
                     {"stroke-width", mark.hollow ? "1.6" : "0.7"}});
  if (!title.empty()) svg_.element("title", {}, title);
  svg_.close();
}

void Plot::exact_lane(double left, double right, double top) {
  svg_.element("rect", {{"x", number(left)},
                        {"y", number(top)},
                        {"width", number(right - left)},
                        {"height", "32"},
                        {"fill", "#e9f3ea"}});
  text(left - 8, top + 20, "tick end", "exact");
}

void Plot::error_ticks(const LogAxis& axis, double left, double right) {
  const int step = (axis.last - axis.first + 8) / 9;
  for (int e = axis.last; e >= axis.first; e -= step) {
    const double y = axis.begin + (axis.end - axis.begin) * (e - axis.first) / (axis.last - axis.first);
    line("grid", left, y, right, y);
    text(left - 8, y + 4, "tick end", power_of_ten(e));
  }
}

}  // namespace isocast::bench
