// What an evaluation of a formula costs.
#pragma once

#include <isocast/implicit/expression/tape.h>

namespace isocast {

/// Operations of one evaluation, counted in sums of intervals: of intervals, or of affine forms; roughly what
/// a profile of the kernels shows.
[[nodiscard]] double tape_cost(const Tape& tape, bool affine);

}  // namespace isocast
