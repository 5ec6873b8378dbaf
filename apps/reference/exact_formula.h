// A formula with its numbers as they stand, for arithmetic of any precision.
#pragma once

#include <isocast/apps/reference/ball.h>
#include <isocast/apps/reference/flint_values.h>
#include <isocast/implicit/expression/expression.h>

#include <string>
#include <vector>

namespace isocast::reference {

/// A rational number, or that of the name "pi", "e" or "phi".
struct ExactConstant {
  std::string name;
  Rational value;
};
[[nodiscard]] Ball ball_of(const ExactConstant& constant, slong bits);

/// f - iso at w = time: the nodes that this needs, operands first and the result last. `a` of a constant is
/// its place in `constants`, of a variable 0..2; no other variable is left.
struct ExactFormula {
  std::vector<Node> nodes;
  std::vector<ExactConstant> constants;
};

/// iso, time  finite, taken exactly
[[nodiscard]] ExactFormula exact_formula(const Expression& expression, double iso, double time);

}  // namespace isocast::reference
