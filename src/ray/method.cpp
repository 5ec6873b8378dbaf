#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/base/error.h>
#include <isocast/ray/method.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace isocast {

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

namespace {

// The number of the word of an option with choices.
double place_of(std::string_view word, const MethodOption& option, std::string_view name) {
  const std::vector<std::string_view> words = words_of(option.choices);
  const auto found = std::ranges::find(words, word);
  if (found == words.end())
    throw InputError(fmt::format("--set {}={}: expected one of: {}", name, word, fmt::join(words, ", ")));
  return static_cast<double>(found - words.begin());
}

}  // namespace

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
    if (!option->choices.empty()) {
      values[name] = place_of(text, *option, name);
      continue;
    }
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
