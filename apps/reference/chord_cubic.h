// The trilinear field of a cell along a chord as a cubic, exactly, and the signs beside its roots.
#pragma once

#include <isocast/apps/reference/exact_cubic.h>

namespace isocast::reference {

/// A chord of a cell: corner values f, x fastest, times any positive number; entry and exit in the cell's
/// coordinates, times `one`.
struct ExactChord {
  mpz_class f[8], entry[3], exit[3], one;
};

/// f along a chord, s from 0 at entry to 1 at exit, times one^3: Bernstein coefficients times (1, 3, 3, 1),
/// and powers of s.
struct ChordCubic {
  ExactCubic bernstein, power;
};
[[nodiscard]] ChordCubic cubic_along(const ExactChord& chord);

/// A root with the sign of f on both sides; outside [0, 1] nothing is negative.
struct SidedRoot {
  ExactRoot s;
  bool at_entry, at_exit, negative_before, negative_behind;
};
/// Every distinct root in [0, 1], in order; p is not zero.
[[nodiscard]] std::vector<SidedRoot> sided_roots(const ExactCubic& p);

}  // namespace isocast::reference
