// From values at Chebyshev's points to Bernstein coefficients, once a degree.
#pragma once

#include <isocast/implicit/frustum/block_query.h>

#include <vector>

namespace isocast {

/// Matrices are row-major, (d + 1) x (d + 1).
struct Collocation {
  /// 0.5 - 0.5 cos((2j + 1) pi / (2d + 2)), j = 0..d: Chebyshev's points in [0, 1].
  std::vector<double> points;
  /// Coefficient i = sum over j of from_values[i][j] f(points[j]).
  std::vector<double> from_values;
  /// Its inverse: B_j(points[i]).
  std::vector<double> at_points;
  /// At most how many times the largest |f(points[j])| any polynomial of degree d has in [0, 1]: Lebesgue's
  /// constant.
  double lebesgue;

  [[nodiscard]] DegreeTables view() const {
    return {static_cast<int>(points.size()) - 1, points.data(), from_values.data(), at_points.data(),
            lebesgue};
  }
};

/// For 0 <= degree <= kMostFormDegree; kept for good. Any thread may call it.
///
/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008; inverted in extended precision
[[nodiscard]] const Collocation& collocation(int degree);

/// B_i^degree(x), i = 0..degree.
void bernstein_values(int degree, double x, double* values);

}  // namespace isocast
