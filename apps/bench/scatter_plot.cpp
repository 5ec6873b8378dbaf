#include <fmt/format.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/plot.h>
#include <isocast/apps/bench/scatter_plot.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

constexpr double kWidth = 760, kHeight = 440, kLeft = 66, kRight = 590, kTop = 16, kBottom = 344, kLane = 366;
constexpr const char *kIsas[] = {"scalar", "sse4", "avx2", "avx512"}, *kPrecisions[] = {"float", "double"},
                     *kGrey = "#667";

std::size_t shape_of(const Row& row) {
  return static_cast<std::size_t>(std::ranges::find(kIsas, row.isa) - std::begin(kIsas));
}

std::string title_of(const Row& row, const std::string& unit) {
  std::string text = fmt::format("{} {}\n{}, {}\n{} ({} million rays/s)\nmean error {} {}", row.method,
                                 short_setting(row.setting), row.isa, row.precision, short_time(row.seconds),
                                 short_number(row.mrays_per_s), short_number(row.t_error_mean), unit);
  const auto add = [&](std::int64_t count, const char* what) {
    if (count > 0) text += fmt::format("\n{} {}", grouped(count), what);
  };
  add(row.false_misses, "false misses");
  add(row.false_hits, "false hits");
  add(row.wrong_root, "wrong roots");
  add(row.undecided, "undecided");
  return text;
}

// The axes, and where rows lie.
struct Axes {
  LogAxis x, y;

  explicit Axes(std::span<const Row> rows) {
    std::vector<double> seconds, errors;
    for (const Row& row : rows) {
      seconds.push_back(row.seconds);
      errors.push_back(pareto_error(row));
    }
    x = log_axis(seconds, kLeft + 8, kRight - 8);
    y = log_axis(errors, kBottom, kTop);
  }
  [[nodiscard]] std::array<double, 2> place(const Row& row) const {
    const double error = pareto_error(row);
    return {x.place(row.seconds), error > 0 ? y.place(error) : kLane};
  }
};

void draw_axes(Plot& plot, const Axes& axes, const std::string& unit) {
  plot.exact_lane(kLeft, kRight, kBottom + 6);
  plot.error_ticks(axes.y, kLeft, kRight);
  for (int e = axes.x.first; e <= axes.x.last; ++e) {
    const double seconds = std::pow(10.0, e), x = axes.x.place(seconds);
    plot.line("grid", x, kTop, x, kBottom + 38);
    plot.text(x, kBottom + 56, "tick middle", short_time(seconds));
  }
  plot.text((kLeft + kRight) / 2, kHeight - 10, "name middle", "time for all rays of the case, one thread");
  plot.upright(16, (kTop + kBottom) / 2, fmt::format("mean error in {} + share of failed rays", unit));
}

void draw_legend(Plot& plot, std::span<const Row> rows, const std::vector<std::string>& methods) {
  constexpr double kKey = kRight + 28, kText = kKey + 14;
  double y = kTop + 10;
  const auto key = [&](const PlotMark& mark, std::string_view words) {
    plot.mark(mark);
    plot.text(kText, y + 4, "key", words);
    y += 19;
  };
  for (std::size_t m = 0; m < methods.size(); ++m) key({0, false, kKey, y, 5, method_color(m)}, methods[m]);
  y += 8;
  for (std::size_t i = 0; i < std::size(kIsas); ++i)
    if (std::ranges::find(rows, kIsas[i], &Row::isa) != rows.end())
      key({i, false, kKey, y, 4.5, kGrey}, kIsas[i]);
  y += 8;
  key({0, false, kKey, y, 5, kGrey}, "float");
  key({0, true, kKey, y, 4.5, kGrey}, "double");
  key({0, false, kKey, y, 3.5, kGrey}, "swept setting");
  y += 8;
  plot.line("front", kKey - 8, y, kKey + 6, y);
  plot.text(kText, y + 4, "key", "Pareto front");
}

// Rows of one instruction set, from the fastest to the slowest, as a line.
template <class Wanted>
void join_rows(Plot& plot, const Axes& axes, std::span<const Row> rows, Wanted wanted, std::string kind,
               const std::string& color) {
  for (const std::string_view precision : kPrecisions) {
    std::vector<const Row*> some;
    for (const Row& row : rows)
      if (row.isa == rows.back().isa && row.precision == precision && wanted(row)) some.push_back(&row);
    std::ranges::sort(some, {}, &Row::seconds);
    std::vector<std::array<double, 2>> points;
    for (const Row* row : some) points.push_back(axes.place(*row));
    if (points.size() > 1) plot.join(points, precision == "double" ? kind + " dotted" : kind, color);
  }
}

}  // namespace

std::vector<std::string> methods_of(std::span<const Row> rows) {
  std::vector<std::string> methods;
  for (const Row& row : rows)
    if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
  return methods;
}

std::string scatter_plot(std::span<const Row> rows, const std::string& unit) {
  Plot plot("scatter", kWidth, kHeight);
  const Axes axes(rows);
  const std::vector<std::string> methods = methods_of(rows);
  draw_axes(plot, axes, unit);
  draw_legend(plot, rows, methods);

  // fronts lie under the methods' own lines, and these under the marks
  join_rows(
      plot, axes, rows, [](const Row& row) { return row.pareto; }, "front", "#d9d2c0");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const auto swept = [&](const Row& row) { return row.method == methods[m] && !row.setting.empty(); };
    join_rows(plot, axes, rows, swept, "sweep", method_color(m));
  }
  for (const Row& row : rows) {
    const auto m = static_cast<std::size_t>(std::ranges::find(methods, row.method) - methods.begin());
    const auto [x, y] = axes.place(row);
    plot.mark(
        {shape_of(row), row.precision == "double", x, y, row.setting.empty() ? 5 : 3.5, method_color(m)},
        title_of(row, unit));
  }
  return plot.finish();
}

}  // namespace isocast::bench
