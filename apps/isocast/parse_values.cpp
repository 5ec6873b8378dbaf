#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/nearest_name.h>

#include <algorithm>
#include <charconv>

namespace isocast {
namespace {

[[noreturn]] void fail(std::string_view option, std::string_view text, std::string_view expected) {
  throw InputError(fmt::format("{}: found {}, expected {}", option, in_quotes(text), expected));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t comma; (comma = text.find(',')) != std::string_view::npos; text.remove_prefix(comma + 1))
    parts.push_back(trimmed(text.substr(0, comma)));
  parts.push_back(trimmed(text));
  return parts;
}

}  // namespace

double parse_number(std::string_view text, std::string_view option) {
  const std::optional<Constant> number = decimal_constant(trimmed(text));
  if (!number) fail(option, text, "a number");
  return number->value;
}

std::vector<double> parse_numbers(std::string_view text, std::string_view option) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text)) numbers.push_back(parse_number(part, option));
  return numbers;
}

std::array<std::int64_t, 3> parse_dims(std::string_view text, std::string_view option) {
  const std::vector<std::string_view> parts = split(text);
  std::array<std::int64_t, 3> dims;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view part = parts[std::min(axis, parts.size() - 1)];
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), dims[axis]);
    const bool whole = error == std::errc() && end == part.data() + part.size() && dims[axis] > 0;
    if (!whole || (parts.size() != 1 && parts.size() != 3))
      fail(option, text, "N or X,Y,Z, whole numbers above 0");
  }
  return dims;
}

Domain parse_domain(std::string_view text, std::string_view option) {
  const std::vector<double> numbers = parse_numbers(text, option);
  if (numbers.size() != 2 && numbers.size() != 6) fail(option, text, "LO,HI or XLO,XHI,YLO,YHI,ZLO,ZHI");
  Domain domain;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t place = numbers.size() == 2 ? 0 : 2 * axis;
    domain.lo[axis] = numbers[place];
    domain.hi[axis] = numbers[place + 1];
    if (!(domain.lo[axis] < domain.hi[axis])) fail(option, text, "every LO below its HI");
  }
  return domain;
}

std::pair<std::string, std::string> parse_key_value(std::string_view text, std::string_view option) {
  const std::size_t equals = text.find('=');
  const std::string_view key = trimmed(text.substr(0, equals));
  const std::string_view value = equals == std::string_view::npos ? "" : trimmed(text.substr(equals + 1));
  if (key.empty() || value.empty()) fail(option, text, "NAME=VALUE");
  return {std::string(key), std::string(value)};
}

Parameters parse_parameters(const std::vector<std::string>& words, std::string_view option) {
  Parameters parameters;
  for (const std::string& word : words) {
    const auto [name, value] = parse_key_value(word, option);
    const std::optional<Constant> number = decimal_constant(value);
    if (!number) fail(option, word, "NAME=NUMBER");
    parameters.push_back({name, *number});
  }
  return parameters;
}

std::string typed_formula(const std::string& word) { return word.starts_with(" -") ? word.substr(1) : word; }

}  // namespace isocast
