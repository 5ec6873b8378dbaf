// Arb's balls as values: the truth that inclusions are held against.
#pragma once

#include <isocast/apps/reference/ball.h>
#include <math/inclusion_names.h>

namespace isocast::test {

using reference::Ball;

/// The same operation as apply() of inclusion_operations.h, on real numbers known to about 200 bits (fewer
/// where their size is beyond Arb); not a number where it is or may be undefined.
[[nodiscard]] Ball truth(Inclusion operation, const Ball& a, const Ball& b, int n);

/// a b + c.
[[nodiscard]] Ball multiply_add(const Ball& a, const Ball& b, const Ball& c);

}  // namespace isocast::test
