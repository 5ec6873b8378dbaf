// Logarithmic axes of plots, and how their numbers are written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// Whole decades from 10^first to 10^last onto [begin, end] (end < begin: upwards), in the plot's units.
struct LogAxis {
  int first = 0, last = 1;
  double begin = 0, end = 1;
  /// value > 0; what lies outside goes to the axis's end.
  [[nodiscard]] double place(double value) const;
};

/// The decades that hold all values above 0, of at least one decade.
[[nodiscard]] LogAxis log_axis(const std::vector<double>& values, double begin, double end);

/// "10⁻³".
[[nodiscard]] std::string power_of_ten(int exponent);
/// Two digits: "0.034", "12", "3", "3.4·10⁻⁷".
[[nodiscard]] std::string short_number(double value);
/// "340 µs", "3.4 ms", "12 s".
[[nodiscard]] std::string short_time(double seconds);
/// "12 345", with blanks that do not break a line.
[[nodiscard]] std::string grouped(std::int64_t count);
/// A --set text for readers: powers of two as such, other numbers short.
[[nodiscard]] std::string short_setting(std::string_view setting);

}  // namespace isocast::bench
