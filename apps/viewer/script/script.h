// Scripts of the viewer: what a person does with mouse and keyboard, a command a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::viewer {

/// `name` with its words; text between quotes is one word.
struct ScriptCommand {
  int line;
  std::string name;
  std::vector<std::string> words;
};

/// Empty lines and what follows # are left out. Throws InputError "FILE:LINE: ..." for an unknown command, or
/// for words that it does not take.
[[nodiscard]] std::vector<ScriptCommand> read_script(const std::filesystem::path& file);
[[nodiscard]] std::vector<ScriptCommand> parse_script(const std::string& text, const std::string& file);

}  // namespace isocast::viewer
