// How steep a formula is, for methods whose steps depend on it.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/math/box.h>

namespace isocast {

/// The median length of f's gradient at 1024 points spread over the box (the sequence of the plastic number's
/// cousin in three dimensions, Roberts 2018); 1 where it has none.
[[nodiscard]] double median_gradient(const Tape& tape, const Box& box, double time);

}  // namespace isocast
