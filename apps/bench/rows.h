// The rows of results.csv and results.json: interface.md names the columns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// One case x method x instruction set x precision x setting. `rays` counts all rays of the case; seconds are
/// the median of the repetitions and seconds_mad their median absolute deviation; errors are over the hits
/// that are not wrong roots. Rays that the reference leaves undecided are in no error.
struct Row {
  std::string suite, case_name, method, isa, precision, setting, proves;
  std::int64_t rays = 0;
  double seconds = 0, seconds_mad = 0, mrays_per_s = 0;
  std::int64_t false_misses = 0, false_hits = 0, wrong_root = 0, undecided = 0;
  double t_error_mean = 0, t_error_p50 = 0, t_error_p99 = 0, t_error_max = 0;
  double normal_error_deg_p50 = 0, normal_error_deg_max = 0;
  bool pareto = false;
  std::int64_t undecided_reference = 0;

  /// Rays that were not answered rightly: with a wrong answer, or with none.
  [[nodiscard]] std::int64_t failures() const { return false_misses + false_hits + wrong_root + undecided; }
};

/// Errors of the hits that are right.
struct ErrorSamples {
  std::vector<double> t, normal_deg;
  /// The columns that sum them up.
  void summarize(Row& row) const;
};

/// The value that a share q in [0, 1] of the values does not exceed (nearest rank); 0 for none.
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// Where the numbers come from: processor, compiler, commit, date.
struct Provenance {
  std::string processor, compiler, commit, date;
  unsigned cores = 0;
};
[[nodiscard]] Provenance provenance();

[[nodiscard]] std::string csv_of(const std::vector<Row>& rows);
[[nodiscard]] std::string json_of(const std::vector<Row>& rows, const Provenance& provenance);

/// Makes the folder if it is missing; throws InputError if results could not be written there, before the
/// work is done.
void prepare_folder(const std::filesystem::path& folder);
/// results.csv and results.json in a prepared folder.
void write_results(const std::filesystem::path& folder, const std::vector<Row>& rows,
                   const Provenance& provenance);

}  // namespace isocast::bench
