// What isocast info says of a formula.
#pragma once

#include <isocast/apps/scene_build/formula_input.h>

namespace isocast {

/// To stdout, as a table or as one JSON object: domain, whether it is a polynomial in x, y and z, its degree
/// and its terms with exact coefficients, or what keeps it from being one; `reduced` in JSON where its terms
/// have a lower degree than its text lets expect.
void print_formula_info(const FormulaInput& formula, double time, bool json);

}  // namespace isocast
