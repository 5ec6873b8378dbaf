#include <fmt/format.h>
#include <isocast/apps/bench/log_axis.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace isocast::bench {
namespace {

std::string superscript(int exponent) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(exponent)) text += c == '-' ? "⁻" : digits[c - '0'];
  return text;
}

}  // namespace

double LogAxis::place(double value) const {
  const double share = std::clamp((std::log10(value) - first) / (last - first), 0.0, 1.0);
  return begin + share * (end - begin);
}

LogAxis log_axis(const std::vector<double>& values, double begin, double end) {
  double lo = 1e300, hi = 0;
  for (const double value : values) {
    if (!(value > 0)) continue;
    lo = std::min(lo, value);
    hi = std::max(hi, value);
  }
  if (hi == 0) lo = hi = 1;
  const int first = static_cast<int>(std::floor(std::log10(lo)));
  return {first, std::max(static_cast<int>(std::ceil(std::log10(hi))), first + 1), begin, end};
}

std::string power_of_ten(int exponent) { return fmt::format("10{}", superscript(exponent)); }

std::string short_number(double value) {
  if (value == 0) return "0";
  const std::string digits = fmt::format("{:.1e}", value);  // rounded: 9.96 is 1.0e+01
  const std::size_t e = digits.find('e');
  const int exponent = std::atoi(digits.c_str() + e + 1);
  if (exponent < -3 || exponent > 4) return fmt::format("{}·{}", digits.substr(0, e), power_of_ten(exponent));
  std::string text = fmt::format("{:.{}f}", value, std::max(0, 1 - exponent));
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string short_time(double seconds) {
  if (seconds < 1e-3) return short_number(seconds * 1e6) + " µs";
  if (seconds < 1) return short_number(seconds * 1e3) + " ms";
  return short_number(seconds) + " s";
}

std::string grouped(std::int64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t end = text.size(); end > 3; end -= 3)
    text.insert(end - 3, "\u202f");  // a narrow blank that keeps the line
  return text;
}

std::string short_setting(std::string_view setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string_view::npos || setting.find(' ') != std::string_view::npos)
    return std::string(setting);
  const std::string word(setting.substr(equals + 1));
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (*end != '\0' || word.size() < 6) return std::string(setting);
  int exponent = 0;
  const bool power = std::frexp(value, &exponent) == 0.5;
  return fmt::format("{}={}", setting.substr(0, equals),
                     power ? fmt::format("2{}", superscript(exponent - 1)) : short_number(value));
}

}  // namespace isocast::bench
