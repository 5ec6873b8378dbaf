// Base64 (RFC 4648).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace isocast {

/// At most `limit` bytes from the start of `text`. White space is skipped; padding may stand inside, as where
/// a header and its data were encoded one after the other.
///
/// throws  InputError (with the path) at a character that is none of base64's, or a group of four that is cut
///         short
[[nodiscard]] std::vector<std::byte> decode_base64(std::string_view text, std::size_t limit,
                                                   const std::filesystem::path& path);

}  // namespace isocast
