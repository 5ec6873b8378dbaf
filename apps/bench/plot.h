// What the plots of the report are drawn with.
#pragma once

#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/markup.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// The colour of the n-th method.
[[nodiscard]] std::string method_color(std::size_t n);

/// shape  0 circle, 1 square, 2 triangle, 3 diamond, of about `radius`
struct PlotMark {
  std::size_t shape;
  bool hollow;
  double x, y, radius;
  std::string color;
};

/// An SVG in the making, in its own units from the upper left corner. `kind` are the classes of its style:
/// tick, name or key, with end or middle, for texts; grid, whisker, sweep, front, dotted for lines.
class Plot {
 public:
  /// kind  a class of the whole
  Plot(std::string_view kind, double width, double height);

  void text(double x, double y, std::string_view kind, std::string_view words);
  /// Upwards, around its middle.
  void upright(double x, double y, std::string_view words);
  void line(std::string_view kind, double x0, double y0, double x1, double y1, const std::string& color = "");
  void join(const std::vector<std::array<double, 2>>& points, std::string_view kind,
            const std::string& color);
  /// `title` appears under the pointer.
  void mark(const PlotMark& mark, const std::string& title = "");

  /// The lane of errors that are 0, 32 high.
  void exact_lane(double left, double right, double top);
  /// The powers of ten of an axis of errors that ends at `left`, and lines from them to `right`.
  void error_ticks(const LogAxis& axis, double left, double right);

  /// A document of its own, which can stand in HTML, too.
  [[nodiscard]] std::string finish() { return svg_.finish(); }

 private:
  Markup svg_;
};

}  // namespace isocast::bench
