// The operations of inclusions as those of formulas.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <math/inclusion_names.h>

namespace isocast::test {

/// Not of hypot and mod, which formulas write in simpler ones.
[[nodiscard]] constexpr Op op_of(Inclusion operation) {
  if (operation == Inclusion::step) return Op::step;
  if (operation == Inclusion::choose) return Op::choose;
  return static_cast<Op>(static_cast<int>(operation) + static_cast<int>(Op::negate));
}
static_assert(op_of(Inclusion::round) == Op::round && op_of(Inclusion::atan2) == Op::atan2);

}  // namespace isocast::test
