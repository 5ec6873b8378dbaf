// Values of options that several verbs share, from text; what cannot be read is an InputError that names the
// option.
#pragma once

#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/parse.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isocast {

/// A finite number; blanks around it mean nothing.
[[nodiscard]] double parse_number(std::string_view text, std::string_view option);

/// Finite numbers with commas between them.
[[nodiscard]] std::vector<double> parse_numbers(std::string_view text, std::string_view option);

/// "N" for all three axes or "X,Y,Z": whole numbers above 0.
[[nodiscard]] std::array<std::int64_t, 3> parse_dims(std::string_view text, std::string_view option);

/// "LO,HI" for all three axes or "XLO,XHI,YLO,YHI,ZLO,ZHI", every LO below its HI.
[[nodiscard]] Domain parse_domain(std::string_view text, std::string_view option);

/// "key=value"; neither may be empty.
[[nodiscard]] std::pair<std::string, std::string> parse_key_value(std::string_view text,
                                                                  std::string_view option);

/// "name=number" words as parameters of a formula, their numbers kept exactly.
[[nodiscard]] Parameters parse_parameters(const std::vector<std::string>& words, std::string_view option);

/// A formula as it was typed: without the blank that main puts before a leading minus sign, so that columns
/// in messages are the user's.
[[nodiscard]] std::string typed_formula(const std::string& word);

}  // namespace isocast
