// A method as a row of plain data: the command line, `isocast methods`, the bench and the docs are generated
// from it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// One `--set NAME=VALUE` of a method. With `choices`, words with a space between, VALUE is one of them and
/// the numbers count them from 0.
struct MethodOption {
  std::string_view name;
  double default_value, lo, hi;
  bool integer;
  std::string_view unit;  // "" for counts and switches
  std::string_view meaning;
  std::string_view choices = {};
};

struct Method {
  std::string_view name;
  std::string_view applies_to;  // "volume" | "formula"
  std::string_view proves;      // "nothing" | "hits" | "misses" | "both"
  std::string_view arithmetic;  // "basic" (+ - * / sqrt: the same bits everywhere) | "library"
  std::string_view precisions;  // "float double"
  std::span<const MethodOption> options;
  std::string_view source;
};

/// The words of a MethodOption's choices.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view choices);

/// The values of `settings` ("iterations" -> "5") as numbers, defaults filled in. Throws InputError for an
/// unknown name (with those that exist), a value that is no number, no integer where one is due, or outside
/// its range.
[[nodiscard]] std::map<std::string, double> resolve_options(
    const Method& method, const std::map<std::string, std::string>& settings);

/// The row of that name, or an InputError that lists the names.
[[nodiscard]] const Method& find_method(std::span<const Method> methods, std::string_view name);

}  // namespace isocast
