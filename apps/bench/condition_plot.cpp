#include <fmt/format.h>
#include <isocast/apps/bench/condition_plot.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/plot.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

constexpr double kWidth = 420, kHeight = 440, kLeft = 58, kRight = 408, kTop = 16, kBottom = 344, kLane = 366;

struct Decades {
  int first = kLastDecade, last = kFirstDecade;
  double width = 1;
  [[nodiscard]] double left(int decade) const { return kLeft + (decade - first) * width; }
};

Decades decades_of(std::span<const ConditionCurve> curves) {
  Decades decades;
  for (const ConditionCurve& curve : curves)
    for (const ConditionBin& bin : curve.bins) {
      decades.first = std::min(decades.first, bin.decade);
      decades.last = std::max(decades.last, bin.decade);
    }
  decades.last = std::max(decades.first, decades.last);
  decades.width = (kRight - kLeft) / (decades.last - decades.first + 1);
  return decades;
}

LogAxis errors_of(std::span<const ConditionCurve> curves) {
  std::vector<double> errors;
  for (const ConditionCurve& curve : curves)
    for (const ConditionBin& bin : curve.bins) {
      errors.push_back(bin.p50);
      errors.push_back(bin.max);
    }
  return log_axis(errors, kBottom, kTop);
}

std::string title_of(const ConditionCurve& curve, const ConditionBin& bin, const std::string& unit) {
  return fmt::format("{}, {}\ncondition from {}\nmedian error {} {}, largest {}\n{} of {} rays failed",
                     curve.method, curve.precision, power_of_ten(bin.decade), short_number(bin.p50), unit,
                     short_number(bin.max), grouped(bin.failures), grouped(bin.rays));
}

}  // namespace

std::string condition_plot(std::span<const ConditionCurve> curves, const std::vector<std::string>& methods,
                           const std::string& unit) {
  Plot plot("condition", kWidth, kHeight);
  const Decades decades = decades_of(curves);
  const LogAxis axis = errors_of(curves);
  const auto top = [&](double error) { return error > 0 ? axis.place(error) : kLane; };

  plot.exact_lane(kLeft, kRight, kBottom + 6);
  plot.error_ticks(axis, kLeft, kRight);
  for (int d = decades.first; !curves.empty() && d <= decades.last + 1; ++d) {
    plot.line("grid", decades.left(d), kTop, decades.left(d), kBottom + 38);
    plot.text(decades.left(d), kBottom + 54, "tick middle", power_of_ten(d));
  }
  if (!curves.empty())
    for (const ConditionBin& bin : curves.front().bins)
      plot.text(decades.left(bin.decade) + decades.width / 2, kBottom + 72, "tick middle", grouped(bin.rays));
  plot.text(kLeft - 8, kBottom + 72, "tick end", "rays");
  plot.text((kLeft + kRight) / 2, kHeight - 6, "name middle", "condition of the first root");

  // a method's marks stand side by side within a decade
  for (const ConditionCurve& curve : curves) {
    const auto m = static_cast<std::size_t>(std::ranges::find(methods, curve.method) - methods.begin());
    const bool hollow = curve.precision == "double";
    const double place =
        (static_cast<double>(m) + (hollow ? 0.7 : 0.3)) / static_cast<double>(methods.size());
    std::vector<std::array<double, 2>> points;
    for (const ConditionBin& bin : curve.bins) {
      if (bin.failures == bin.rays) continue;
      const double x = decades.left(bin.decade) + decades.width * (0.08 + 0.84 * place);
      points.push_back({x, top(bin.p50)});
      plot.line("whisker", x, top(bin.p50), x, top(bin.max), method_color(m));
    }
    plot.join(points, hollow ? "sweep dotted" : "sweep", method_color(m));
    std::size_t n = 0;
    for (const ConditionBin& bin : curve.bins)
      if (bin.failures < bin.rays) {
        plot.mark({0, hollow, points[n][0], points[n][1], 3.5, method_color(m)}, title_of(curve, bin, unit));
        ++n;
      }
  }
  return plot.finish();
}

}  // namespace isocast::bench
