// How far the value of a polynomial in double precision can be from the true one, all over a box.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/math/box.h>

namespace isocast {

/// At most so far is f, evaluated by the tape in double precision at a point whose coordinates are off by
/// `slack`, from f at the true point; the box holds both. f is a polynomial (expression/degree.h). Infinite
/// where nothing is known.
///
/// source  running error analysis with ranges in place of values; Higham: Accuracy and stability of numerical
///         algorithms, SIAM 2002, chapter 3
[[nodiscard]] double rounding_bound(const Tape& tape, const Box& box, double time, double slack);

}  // namespace isocast
