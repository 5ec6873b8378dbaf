// The rows of the method table for formulas.
#pragma once

#include <isocast/implicit/solve/kernels.h>
#include <isocast/ray/method.h>

#include <map>
#include <span>
#include <string>

namespace isocast {

/// interval, affine: in the order of FormulaMethod.
[[nodiscard]] std::span<const Method> formula_methods();

/// eps       a length in world units; 0: from eps_rel
/// eps_rel   of the domain's longest edge
struct FormulaMethodChoice {
  FormulaMethod method = FormulaMethod::affine;
  FormulaOptions options;
  double eps = 0, eps_rel = 0x1p-11;
};
/// A row with its `--set` values; "auto" is affine. Throws InputError as find_method and resolve_options do.
[[nodiscard]] FormulaMethodChoice choose_formula_method(std::string_view name,
                                                        const std::map<std::string, std::string>& settings);

}  // namespace isocast
