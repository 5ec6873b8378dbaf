// Text of a formula to its graph.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// A named number of a formula.
struct Parameter {
  std::string name;
  Constant value;
};
/// Of two parameters with one name the later holds, so defaults followed by what overrides them is one list.
using Parameters = std::vector<Parameter>;

inline constexpr std::size_t kMaxFormulaBytes = std::size_t{1} << 20;
inline constexpr int kMaxFormulaNesting = 1000;

/// Reads f(x, y, z, w) as it stands; nothing is simplified.
///
/// grammar   numbers, x y z w, parameters, pi e phi, + - * / ^, parentheses, the functions of builtins.h. ^
///           binds tighter than the minus sign before it (-x^2 is -(x^2)) and groups to the right; its
///           exponent may have a sign (2^-1)
/// names     a parameter may be called like a constant, which it then hides, but not like a variable or a
///           function
/// source    the name of the formula in messages
/// throws    InputError "source:line:column: found ..., expected ..."
[[nodiscard]] Expression parse_expression(std::string_view text, const Parameters& parameters = {},
                                          std::string_view source = "formula");

}  // namespace isocast
