// Polynomials in two variables from their values at Padua points, as Chebyshev series.
#pragma once

#include <vector>

namespace isocast {

/// Interpolation by polynomials p(x, y) of a total degree d >= 1 over [-1, 1]^2, at the fewest points.
///
/// columns, rows  d + 1 and d + 2 numbers; the points are (columns[i], rows[j]) with i + j even
/// from_columns   row-major (d + 1) x (d + 1): a_k(rows[j]) = sum over i, i + j even, of
///                from_columns[k][i] p(columns[i], rows[j])
/// from_rows      row-major (d + 1) x (d + 2): p = sum over k + l <= d of b_kl T_k(x) T_l(y) with
///                b_kl = sum over j of from_rows[l][j] a_k(rows[j])
/// lebesgue       at most how many times the largest |p| at the points |p| is anywhere
///
/// source  Bos, Caliari, De Marchi, Vianello, Xu: Bivariate Lagrange interpolation at the Padua points: the
///         generating curve approach, Journal of Approximation Theory 143, 2006
struct Padua {
  std::vector<double> columns, rows, from_columns, from_rows;
  double lebesgue;
};

/// For 1 <= degree <= kMostFormDegree; kept for good. Any thread may call it.
[[nodiscard]] const Padua& padua(int degree);

/// Row-major, of order kMostFormDegree + 1, upper triangular: Chebyshev coefficients over [-1, 0] (side 0) or
/// [0, 1] (side 1), each as [-1, 1], from those over [-1, 1]. Kept for good.
[[nodiscard]] const std::vector<double>& chebyshev_half(int side);

/// T_i(x), i = 0..degree, and their slopes.
void chebyshev_values(int degree, double x, double* values, double* slopes);

}  // namespace isocast
