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

/// Reads f(x, y, z, w) as it stands; nothing is simplified. Nodes that the root does not need may be there.
///
/// grammar   definitions, each with ';' after it, then one expression; docs/formulas.md has all of it
///           definition   [let] name = expression   |   [let] name(name, ...) = expression
///           expression   operands and, from loose to tight: or, and, not, < > <= >= == !=, + -, * /, the
///           sign,
///                        ^ (to the right; its exponent may have a sign: 2^-1)
///           operand      number, name, (expression), name(expression, ...),
///                        sum(name in [expression, ...], expression),
///                        sum((name, ...) in [(expression, ...), ...], expression)
/// names     x y z w, functions (builtins.h, sum) and keywords (let in and or not) cannot be given away; a
///           parameter may be called like a constant (pi e phi), which it then hides, a definition too, and
///           the names that a function or a sum binds hide all of these
/// bounds    kMaxFormulaBytes, kMaxFormulaNesting, and kMaxFormulaWords of reader.h after each call of a
///           function of the formula's own and each element of a sum is written out; a function knows only
///           what is defined before it, so nothing calls itself
/// source    the name of the formula in messages
/// throws    InputError "source:line:column: found ..., expected ..."
[[nodiscard]] Expression parse_expression(std::string_view text, const Parameters& parameters = {},
                                          std::string_view source = "formula");

}  // namespace isocast
