// Words and numbers of text headers, and the sentence that tells a mistake in a file.
#pragma once

#include <isocast/base/error.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// "cannot read PATH: WHAT", to be thrown.
[[nodiscard]] InputError read_error(const std::filesystem::path& path, const std::string& what);

[[nodiscard]] std::string lower_case(std::string_view text);
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// The words between any of `separators`, none of them empty.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text,
                                                        std::string_view separators = " \t\r\n");

/// The one file of samples that a text header names, relative to the header's folder. Throws InputError for
/// names that mean several files: LIST, or a pattern with %.
[[nodiscard]] std::filesystem::path data_file_beside(const std::filesystem::path& header,
                                                     std::string_view name);

/// A word that is a number as a whole, for N int64_t, uint64_t and double ("nan" and "inf" are numbers); else
/// nothing.
template <class N> [[nodiscard]] std::optional<N> to_number(std::string_view word);
/// All words as numbers, exactly `count` of them; else nothing.
template <class N>
[[nodiscard]] std::optional<std::vector<N>> to_numbers(std::string_view text, std::size_t count);

}  // namespace isocast
