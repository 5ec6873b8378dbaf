#include <fmt/format.h>
#include <isocast/implicit/expression/constant.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace isocast {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The value of "e-3" or nothing at all; saturates, since any such exponent is far beyond the range of double.
std::optional<std::int64_t> read_exponent(std::string_view text) {
  if (text.empty()) return 0;
  if (text[0] != 'e' && text[0] != 'E') return std::nullopt;
  text.remove_prefix(text.size() > 1 && text[1] == '+' ? 2 : 1);
  std::int64_t exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  const std::int64_t limit = std::int64_t{1} << 40;
  if (error == std::errc::result_out_of_range) return text[0] == '-' ? -limit : limit;
  return std::clamp(exponent, -limit, limit);
}

// digits * 10^exponent without zeros at either end of the digits; zero has none.
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t exponent = 0;

  [[nodiscard]] std::string text() const {
    return digits.empty() ? "0e0" : fmt::format("{}{}e{}", negative ? "-" : "", digits, exponent);
  }
};

std::optional<Decimal> read_decimal(std::string_view text) {
  // sign
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  if (decimal.negative || text.starts_with('+')) text.remove_prefix(1);

  // digits with at most one point
  bool point = false;
  std::size_t i = 0, digit_count = 0;
  for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !point)); ++i) {
    if (text[i] == '.') {
      point = true;
      continue;
    }
    ++digit_count;
    decimal.exponent -= point;
    if (text[i] != '0' || !decimal.digits.empty()) decimal.digits += text[i];
  }
  const std::optional<std::int64_t> written = read_exponent(text.substr(i));
  if (digit_count == 0 || !written) return std::nullopt;

  // one spelling for one number
  const std::size_t kept = decimal.digits.find_last_not_of('0') + 1;
  decimal.exponent += *written + static_cast<std::int64_t>(decimal.digits.size() - kept);
  decimal.digits.resize(kept);
  return decimal;
}

// All digits of a double: 767 suffice for every one.
std::string all_digits(double value) { return read_decimal(fmt::format("{:.766e}", value)).value().text(); }

// Whether `value`, the double nearest to `decimal`, is that number.
bool is_exact(const Decimal& decimal, double value) {
  constexpr std::size_t kSurelyFits = 19;
  if (decimal.digits.size() > kSurelyFits) return all_digits(value) == decimal.text();

  // what remains of digits * 5^exponent without its factors of two has to fit into 53 bits
  std::uint64_t rest = 0;
  for (const char digit : decimal.digits) rest = 10 * rest + static_cast<std::uint64_t>(digit - '0');
  if (rest == 0) return true;
  rest >>= std::countr_zero(rest);
  std::int64_t exponent = decimal.exponent;
  for (; exponent < 0 && rest % 5 == 0; ++exponent) rest /= 5;
  for (; exponent > 0 && rest < (std::uint64_t{1} << 53); --exponent) rest *= 5;
  return exponent == 0 && rest < (std::uint64_t{1} << 53);
}

}  // namespace

std::optional<Constant> decimal_constant(std::string_view literal) {
  const std::optional<Decimal> decimal = read_decimal(literal);
  if (!decimal) return std::nullopt;
  std::string text = decimal->text();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || (value == 0 && !decimal->digits.empty()))
    return std::nullopt;
  return Constant{std::move(text), value, is_exact(*decimal, value)};
}

Constant shortest_constant(double value) { return decimal_constant(fmt::format("{}", value)).value(); }

Constant exact_constant(double value) {
  Constant constant = shortest_constant(value);
  if (!constant.exact) constant = {all_digits(value), value, true};
  return constant;
}

std::optional<Constant> named_constant(std::string_view name) {
  if (name == "pi") return Constant{"pi", std::numbers::pi, false};
  if (name == "e") return Constant{"e", std::numbers::e, false};
  if (name == "phi") return Constant{"phi", std::numbers::phi, false};
  return std::nullopt;
}

}  // namespace isocast
