// What was probably meant by a misspelt name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// The candidate with the fewest edits to `word`; empty without candidates, or when `word` is longer than any
/// name.
[[nodiscard]] std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace isocast
