// What an evaluation of a formula costs.
#pragma once

#include <isocast/implicit/expression/tape.h>

namespace isocast {

/// Operations of one evaluation, counted in sums of intervals: of intervals, or of affine forms; roughly what
/// a profile of the kernels shows.
[[nodiscard]] double tape_cost(const Tape& tape, bool affine);

/// The same of a ray of a picture in the frustum form: its coefficients, its root, its proof.
[[nodiscard]] inline double form_cost(int degree) { return 60 + 3.0 * degree * degree; }

}  // namespace isocast
