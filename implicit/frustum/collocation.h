// From values at Chebyshev's points to Bernstein coefficients, once a degree.
#pragma once

#include <vector>

namespace isocast {

/// Degrees above it are not interpolated in one part.
struct Collocation {
  /// 0.5 - 0.5 cos((2j + 1) pi / (2d + 2)), j = 0..d: Chebyshev's points in [0, 1].
  std::vector<double> points;
  /// Row-major, (d + 1) x (d + 1): coefficient i = sum over j of from_values[i][j] f(points[j]).
  std::vector<double> from_values;
  /// At most how many times the largest |f(points[j])| any polynomial of degree d has in [0, 1]: Lebesgue's
  /// constant.
  double lebesgue;
};

/// For 0 <= degree <= kMostFormDegree; kept for good. Any thread may call it.
///
/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008; inverted in extended precision
[[nodiscard]] const Collocation& collocation(int degree);

/// B_i^degree(x), i = 0..degree.
void bernstein_values(int degree, double x, double* values);

/// Row-major (degree + 1) x (degree + 1): coefficient i over [from, to] = sum over j of matrix[i][j] b_j, b
/// over [0, 1].
[[nodiscard]] std::vector<double> part_matrix(int degree, double from, double to);

}  // namespace isocast
