// A cell whose field along the diagonal is a cubic that the test prescribes.
#pragma once

#include <isocast/apps/reference/cell_reference.h>

#include <bit>

namespace isocast::test {

/// From corner 0 to corner 7, with the given Bernstein coefficients.
inline reference::CellChord diagonal_cell(double c0, double c1, double c2, double c3) {
  const double c[4] = {c0, c1, c2, c3};
  reference::CellChord chord{};
  for (int i = 0; i < 8; ++i) chord.f[i] = c[std::popcount(static_cast<unsigned>(i))];
  for (int i = 0; i < 3; ++i) chord.exit[i] = 1;
  return chord;
}

/// The same with 3 a (s - r)(s - t)(s - u); exact for roots of few bits.
inline reference::CellChord diagonal_cell_with_roots(double a, double r, double t, double u) {
  return diagonal_cell(-3 * a * r * t * u, a * ((1 - r) * t * u + (1 - t) * r * u + (1 - u) * r * t),
                       -a * ((1 - r) * (1 - t) * u + (1 - t) * (1 - u) * r + (1 - u) * (1 - r) * t),
                       3 * a * (1 - r) * (1 - t) * (1 - u));
}

}  // namespace isocast::test
