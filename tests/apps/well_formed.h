// Whether what the report's writers made is well-formed.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace isocast::test {

/// Whether every element is closed in order, and no text holds a bare '<', '>' or '&'; style sheets are
/// passed.
[[nodiscard]] inline bool is_well_formed(std::string_view text) {
  std::vector<std::string> open;
  if (text.starts_with("<!DOCTYPE html>")) text.remove_prefix(15);
  while (!text.empty()) {
    if (text[0] != '<') {
      if (text[0] == '>' && (open.empty() || open.back() != "style")) return false;
      if (text[0] == '&' && text.substr(0, 10).find(';') == text.npos) return false;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = text.find('>');
    if (end == text.npos) return false;
    const std::string_view tag = text.substr(1, end - 1);
    const std::string name(tag.substr(0, tag.find_first_of(" /", 1)));
    if (tag.find('<') != tag.npos || std::ranges::count(tag, '"') % 2 != 0) return false;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    text.remove_prefix(end + 1);
  }
  return open.empty();
}

}  // namespace isocast::test
