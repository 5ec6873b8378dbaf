#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/base/error.h>
#include <isocast/ray/method.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace isocast {

std::map<std::string, double> resolve_options(const Method& method,
                                              const std::map<std::string, std::string>& settings) {
  std::map<std::string, double> values;
  std::vector<std::string_view> names;
  for (const MethodOption& option : method.options) {
    values[std::string(option.name)] = option.default_value;
    names.push_back(option.name);
  }
  for (const auto& [name, text] : settings) {
    const MethodOption* option = nullptr;
    for (const MethodOption& candidate : method.options)
      if (candidate.name == name) option = &candidate;
    if (!option)
      throw InputError(fmt::format("--set {}={}: method {} has no option '{}'; it has: {}", name, text,
                                   method.name, name,
                                   names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size() && !text.empty();
    if (!number || !(value >= option->lo && value <= option->hi) ||
        (option->integer && value != std::floor(value)))
      throw InputError(fmt::format("--set {}={}: expected {} between {} and {}", name, text,
                                   option->integer ? "an integer" : "a number", option->lo, option->hi));
    values[name] = value;
  }
  return values;
}

const Method& find_method(std::span<const Method> methods, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Method& method : methods) {
    if (method.name == name) return method;
    names.push_back(method.name);
  }
  throw InputError(
      fmt::format("method '{}' is unknown; expected auto or one of: {}", name, fmt::join(names, ", ")));
}

}  // namespace isocast
