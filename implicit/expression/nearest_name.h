// What was probably meant by a misspelt name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// The candidate with the fewest edits to `word`; empty without candidates, or when `word` is longer than any
/// name.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

/// `word` in quotes for a message, cut after 40 bytes, without control characters.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace isocast
