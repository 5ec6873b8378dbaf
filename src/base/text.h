// A stranger's words in a message.
#pragma once

#include <string>
#include <string_view>

namespace isocast {

/// `text` between quotes, at most 40 bytes of it, anything but printable ASCII as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace isocast
