#include <isocast/implicit/frustum/by_degree.h>
#include <isocast/implicit/frustum/padua.h>

#include <array>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

using Exact = long double;
constexpr Exact kPi = std::numbers::pi_v<Exact>;

Padua make_padua(int degree) {
  Padua result;
  const Exact column = kPi / degree, row = kPi / (degree + 1);
  for (int i = 0; i <= degree; ++i) result.columns.push_back(static_cast<double>(std::cos(i * column)));
  for (int j = 0; j <= degree + 1; ++j) result.rows.push_back(static_cast<double>(std::cos(j * row)));
  // a cubature's weights are 2 / (d (d + 1)), halved at each border; those of a series 1, 2, 2, ..
  const auto at_border = [](int i, int last) { return i == 0 || i == last ? Exact(0.5) : Exact(1); };
  const auto of_series = [](int k) { return k == 0 ? Exact(1) : Exact(2); };
  for (int k = 0; k <= degree; ++k)
    for (int i = 0; i <= degree; ++i) {
      // T_d(x) T_0(y) is counted twice
      const Exact share = of_series(k) * (k == degree ? Exact(0.5) : Exact(1)) * 2 / degree;
      result.from_columns.push_back(
          static_cast<double>(share * at_border(i, degree) * std::cos(k * i * column)));
    }
  for (int l = 0; l <= degree; ++l)
    for (int j = 0; j <= degree + 1; ++j)
      result.from_rows.push_back(static_cast<double>(of_series(l) / (degree + 1) * at_border(j, degree + 1) *
                                                     std::cos(l * j * row)));
  // the constant's growth, as the paper estimates it, and an eighth more: a test proves it, degree by degree
  const double axis = 2 / std::numbers::pi * std::log(degree + 1) + 1.1;
  result.lebesgue = 1.125 * axis * axis;
  return result;
}

std::vector<double> make_half(int side) {
  // T_i((x -+ 1) / 2) in T_k(x): T_(i+1)(y) = 2 y T_i(y) - T_(i-1)(y)
  constexpr int n = kMostFormDegree + 1;
  const Exact shift = side == 0 ? -1 : 1;
  std::array<std::array<Exact, n>, n> series{};
  series[0][0] = 1;
  series[1] = {shift / 2, Exact(0.5)};
  for (int i = 1; i + 1 < n; ++i)
    for (int k = 0; k <= i + 1; ++k) {
      // x T_k = (T_(k-1) + T_(k+1)) / 2, x T_0 = T_1
      Exact sum = shift * series[i][k] - series[i - 1][k];
      if (k > 0) sum += series[i][k - 1] * (k == 1 ? Exact(1) : Exact(0.5));
      if (k + 1 < n) sum += series[i][k + 1] * Exact(0.5);
      series[i + 1][k] = sum;
    }
  std::vector<double> half(std::size_t(n) * n);
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) half[std::size_t(k) * n + i] = static_cast<double>(series[i][k]);
  return half;
}

}  // namespace

const Padua& padua(int degree) { return made_once<make_padua>(degree); }

const std::vector<double>& chebyshev_half(int side) {
  static const std::array<std::vector<double>, 2> halves = {make_half(0), make_half(1)};
  return halves[static_cast<std::size_t>(side)];
}

void chebyshev_values(int degree, double x, double* values, double* slopes) {
  // the recurrence rounds much near the ends
  Exact value[2] = {1, x}, slope[2] = {0, 1};
  for (int i = 0; i <= degree; ++i) {
    values[i] = static_cast<double>(value[0]), slopes[i] = static_cast<double>(slope[0]);
    const Exact next = 2 * x * value[1] - value[0], next_slope = 2 * value[1] + 2 * x * slope[1] - slope[0];
    value[0] = value[1], value[1] = next;
    slope[0] = slope[1], slope[1] = next_slope;
  }
}

}  // namespace isocast
