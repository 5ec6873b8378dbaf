#include <isocast/implicit/frustum/by_degree.h>
#include <isocast/implicit/frustum/collocation.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

using Wide = long double;

// B_0..B_degree at x, by the recurrence over the degrees.
template <class T> void fill_bernstein(int degree, T x, T* values) {
  values[0] = 1;
  for (int n = 1; n <= degree; ++n) {
    values[n] = x * values[n - 1];
    for (int i = n - 1; i >= 1; --i) values[i] = (1 - x) * values[i] + x * values[i - 1];
    values[0] *= 1 - x;
  }
}

Collocation make_collocation(int degree) {
  const int n = degree + 1;
  Collocation result;
  Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic> values(n, n);
  std::vector<Wide> row(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) {
    const Wide x = (1 - std::cos((2 * j + 1) * std::numbers::pi_v<Wide> / (2 * n))) / 2;
    result.points.push_back(static_cast<double>(x));
    fill_bernstein<Wide>(degree, static_cast<double>(x), row.data());
    for (int i = 0; i < n; ++i) {
      values(j, i) = row[static_cast<std::size_t>(i)];
      result.at_points.push_back(static_cast<double>(values(j, i)));
    }
  }
  const auto inverse = values.partialPivLu().inverse().eval();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) result.from_values.push_back(static_cast<double>(inverse(i, j)));
  // Rivlin: An introduction to the approximation of functions, 1969; rounded up
  result.lebesgue = 2 / std::numbers::pi * std::log(n) + 1.001;
  return result;
}

}  // namespace

const Collocation& collocation(int degree) { return made_once<make_collocation>(degree); }

void bernstein_values(int degree, double x, double* values) { fill_bernstein(degree, x, values); }

}  // namespace isocast
