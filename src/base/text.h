// A stranger's words in a message.
#pragma once

#include <string>
#include <string_view>

namespace isocast {

/// `text` between quotes, at most 40 bytes of it, anything but printable ASCII as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Adds `item` to a list in a sentence; what would make it longer than a few hundred bytes becomes "...".
void add_to_list(std::string& list, std::string_view item);

}  // namespace isocast
