// What an evaluation of a formula costs.
#pragma once

#include <isocast/implicit/expression/tape.h>

namespace isocast {

/// Operations of one evaluation, counted in sums of intervals: of intervals, or of affine forms; roughly what
/// a profile of the kernels shows.
[[nodiscard]] double tape_cost(const Tape& tape, bool affine);

/// The same with what goes around them: finding the next part of a ray, reading the tape.
[[nodiscard]] inline double evaluation_cost(const Tape& tape, bool affine) {
  return 90 + tape_cost(tape, affine);
}
/// The same of a ray of a picture in the frustum form: its coefficients, its root, its proof.
[[nodiscard]] inline double form_cost(int degree) { return 80 + 1.2 * degree * degree; }
/// The same of a ray besides all evaluations: by itself, or together with others of a picture.
inline constexpr double kRayCost = 400, kPictureRayCost = 50;

}  // namespace isocast
