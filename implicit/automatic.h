// The method for a formula when nobody chose one.
#pragma once

#include <isocast/implicit/implicit_surface.h>

namespace isocast {

struct AutomaticMethod {
  FormulaMethod method;
  FormulaPass pass;
  std::string reason;
};
/// interval or affine, whichever needs fewer operations for a fixed set of rays through the domain: its
/// evaluations of the tape, each counted by the cost of the tape's operations in that arithmetic and of what
/// goes around them; certified instead, if that needs fewer still for the middle of a picture of the domain,
/// rays themselves counted too, and `options` ask for nothing that it lacks (beams are not tried where rays
/// take more than 100 affine evaluations, or twice the operations of intervals). Time is not measured, so
/// the choice is the same everywhere. `options` as for the surface; its method is not used.
[[nodiscard]] AutomaticMethod choose_automatically(const Expression& expression, const Domain& domain,
                                                   ImplicitSurfaceOptions options);

}  // namespace isocast
