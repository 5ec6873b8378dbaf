#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/data_gen/sample.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace isocast {
namespace {

// The blocks of one row: y, z and w are the same in all of them.
void evaluate_row(const Tape& tape, double time, const SampleGrid& grid, std::int64_t j, std::int64_t k,
                  std::span<double> values) {
  const auto registers = std::make_unique_for_overwrite<double[]>(std::size_t{tape.registers} * kBlockPoints);
  double x[kBlockPoints], y[kBlockPoints], z[kBlockPoints], w[kBlockPoints];
  std::ranges::fill(y, grid.position(1, j));
  std::ranges::fill(z, grid.position(2, k));
  std::ranges::fill(w, time);
  const double* const inputs[] = {x, y, z, w};
  const auto size = static_cast<std::int64_t>(values.size());
  for (std::int64_t i = 0; i < size; i += kBlockPoints) {
    const int count = static_cast<int>(std::min<std::int64_t>(kBlockPoints, size - i));
    for (int lane = 0; lane < count; ++lane) x[lane] = grid.position(0, i + lane);
    std::copy_n(evaluate_block(tape.view(), inputs, count, registers.get()), count, values.data() + i);
  }
}

void add_values(ValueStatistics& statistics, std::span<const double> values) {
  for (const double value : values) {
    statistics.nan_count += std::isnan(value);
    if (!std::isfinite(value)) continue;
    statistics.lo = std::min(statistics.lo, value);
    statistics.hi = std::max(statistics.hi, value);
  }
}

}  // namespace

ValueStatistics merged(const ValueStatistics& a, const ValueStatistics& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.nan_count + b.nan_count};
}

void check_grid(const SampleGrid& grid, std::int64_t sample_bytes) {
  std::int64_t bytes = sample_bytes;
  for (int axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis];
    const std::int64_t samples = grid.dims[axis];
    const double lo = grid.domain.lo[axis], hi = grid.domain.hi[axis];
    if (samples < 2 || samples > kMaxGridAxis)
      throw InputError(fmt::format("found a resolution of {} along {}, expected 2 to {} samples", samples,
                                   name, kMaxGridAxis));
    if (!(lo < hi) || !std::isfinite((hi - lo) * static_cast<double>(samples)))
      throw InputError(
          fmt::format("found the domain {},{} along {}, expected a finite LO below HI", lo, hi, name));
    if (__builtin_mul_overflow(bytes, samples, &bytes))
      throw InputError(fmt::format("found a resolution of {}x{}x{}, expected less than 2^63 bytes of samples",
                                   grid.dims[0], grid.dims[1], grid.dims[2]));
  }
}

Field formula_field(const Expression& expression, double time) {
  return [tape = make_tape(simplify(expression)), time](const SampleGrid& grid, std::int64_t j,
                                                        std::int64_t k, std::span<double> values) {
    evaluate_row(tape, time, grid, j, k, values);
  };
}

ValueStatistics sample_rows(
    const Field& field, const SampleGrid& grid, std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t row, std::span<const double> values)>& consume) {
  const auto sample_range = [&](const tbb::blocked_range<std::int64_t>& rows, ValueStatistics statistics) {
    std::vector<double> values(static_cast<std::size_t>(grid.dims[0]));
    for (std::int64_t row = rows.begin(); row != rows.end(); ++row) {
      field(grid, row % grid.dims[1], row / grid.dims[1], values);
      add_values(statistics, values);
      consume(row, values);
    }
    return statistics;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::int64_t>(first, last), ValueStatistics{}, sample_range,
                              merged);
}

}  // namespace isocast
