// Fields sampled on a grid over a box.
#pragma once

#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/expression.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>

namespace isocast {

/// dims[a] samples along axis a, the first at domain.lo[a] and the last at domain.hi[a]; x varies fastest.
struct SampleGrid {
  std::array<std::int64_t, 3> dims = {2, 2, 2};
  Domain domain;

  /// Samples along x that lie beside each other; row r has j = r mod dims[1], k = r / dims[1].
  [[nodiscard]] std::int64_t rows() const { return dims[1] * dims[2]; }
  [[nodiscard]] double spacing(int axis) const {
    return (domain.hi[axis] - domain.lo[axis]) / static_cast<double>(dims[axis] - 1);
  }
  [[nodiscard]] double position(int axis, std::int64_t index) const {
    const double extent = domain.hi[axis] - domain.lo[axis];
    return domain.lo[axis] + static_cast<double>(index) * extent / static_cast<double>(dims[axis] - 1);
  }
};

inline constexpr std::int64_t kMaxGridAxis = std::int64_t{1} << 20;

/// Throws InputError unless every axis has 2 to kMaxGridAxis samples, a finite lo below its finite hi, and
/// the samples of `sample_bytes` each have a 64-bit size together.
void check_grid(const SampleGrid& grid, std::int64_t sample_bytes);

/// Fills the row (j, k) of a grid: values[i] is the field at sample (i, j, k). Called from many threads at
/// once.
using Field =
    std::function<void(const SampleGrid& grid, std::int64_t j, std::int64_t k, std::span<double> values)>;

/// f(x, y, z, w = time), simplified, in double precision.
[[nodiscard]] Field formula_field(const Expression& expression, double time = 0);

/// What a field's values were: the finite ones' range (lo > hi when there is none), and how many were NaN.
struct ValueStatistics {
  double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
  std::int64_t nan_count = 0;
};
[[nodiscard]] ValueStatistics merged(const ValueStatistics& a, const ValueStatistics& b);

/// Computes rows [first, last) in parallel and passes each to `consume` with its number, from many threads at
/// once.
ValueStatistics sample_rows(
    const Field& field, const SampleGrid& grid, std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t row, std::span<const double> values)>& consume);

}  // namespace isocast
