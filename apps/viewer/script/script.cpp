#include <fmt/format.h>
#include <isocast/apps/viewer/script/script.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

namespace isocast::viewer {
namespace {

// A command with its words: n a number, t text.
struct Shape {
  const char *name, *words;
};
constexpr Shape kShapes[] = {{"wait", ""},    {"iso", "n"},       {"orbit", "nn"},     {"pan", "nn"},
                             {"zoom", "n"},   {"method", "t"},    {"formula", "t"},    {"time", "n"},
                             {"frame", "n"},  {"param", "tn"},    {"click", "nn"},     {"overlay", "t"},
                             {"object", "t"}, {"press", "t"},     {"type", "tt"},      {"key", "t"},
                             {"drop", "t"},   {"clipboard", "t"}, {"screenshot", "t"}, {"save", "t"},
                             {"quit", ""}};

std::string expected(const Shape& shape) {
  std::string text = shape.name;
  for (const char c : std::string_view(shape.words)) text += c == 'n' ? " NUMBER" : " TEXT";
  return text;
}

bool is_number(const std::string& word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, open = false;
  for (const char c : line) {
    if (c == '#' && !quoted) break;
    if (c == '"') {
      quoted = !quoted;
      if (quoted) words.emplace_back();
      open = quoted;
    } else if (!quoted && (c == ' ' || c == '\t' || c == '\r')) open = false;
    else {
      if (!open) words.emplace_back();
      open = true;
      words.back() += c;
    }
  }
  return words;
}

}  // namespace

std::vector<ScriptCommand> parse_script(const std::string& text, const std::string& file) {
  std::vector<ScriptCommand> commands;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    const auto shape =
        std::ranges::find(kShapes, words.front(), [](const Shape& s) { return std::string(s.name); });
    if (shape == std::end(kShapes)) {
      std::string names;
      for (const Shape& known : kShapes) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
      throw InputError(
          fmt::format("{}:{}: found {}, expected one of {}", file, number, in_quotes(words.front()), names));
    }
    const std::string_view kinds = shape->words;
    bool fits = words.size() == kinds.size() + 1;
    for (std::size_t i = 0; fits && i < kinds.size(); ++i) fits = kinds[i] == 't' || is_number(words[i + 1]);
    if (!fits)
      throw InputError(
          fmt::format("{}:{}: found {}, expected {}", file, number, in_quotes(line), expected(*shape)));
    commands.push_back({number, words.front(), {words.begin() + 1, words.end()}});
  }
  return commands;
}

std::vector<ScriptCommand> read_script(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw InputError(fmt::format("the script {} cannot be read", file.string()));
  return parse_script(text.str(), file.string());
}

}  // namespace isocast::viewer
