// The operations of formulas on balls along a ray, with slopes and decorations.
#pragma once

#include <isocast/apps/reference/ball.h>
#include <isocast/implicit/expression/instruction.h>

namespace isocast::reference {

/// What is known of a function g of s over a range of s.
///
/// value       holds g wherever it is defined
/// slope       where `continuous`: holds (g(b) - g(a)) / (b - a) for all a and b of the range
/// defined     g has a value everywhere in the range
/// continuous  so it has, and is continuous
/// empty       g has a value nowhere in the range; the balls then mean nothing
/// A ball of which nothing is known is 0 +- infinity, never NaN.
struct Enclosure {
  Ball value, slope;
  bool defined = true, continuous = true, empty = false;
};

/// A number of the formula, or s itself: the slope is 0 or 1, or what else it is.
[[nodiscard]] Enclosure enclosure_of(const Ball& value, const Ball& slope = Ball());

/// op(a, b, c) with n as in Node (expression.h), of as many operands as the operation has; computed with
/// `bits`, slopes only if `sloped`.
[[nodiscard]] Enclosure apply(Op op, int n, const Enclosure& a, const Enclosure& b, const Enclosure& c,
                              slong bits, bool sloped);

}  // namespace isocast::reference
