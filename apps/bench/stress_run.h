// One stress case through every method for such an object, in both precisions, as the methods are by default.
#pragma once

#include <isocast/apps/bench/rows.h>
#include <isocast/apps/bench/stress_case.h>
#include <isocast/apps/bench/stress_judge.h>
#include <isocast/isa/cpu.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// size   rays along both edges of a case's square of rays
/// cells  of each family
/// cache  the folder in which the reference's answers are kept; empty: nowhere
struct StressOptions {
  int size = 24;
  std::uint64_t cells = 4096;
  Isa isa = widest_isa();
  std::filesystem::path cache = {};
};

/// What a method made of a case in one precision.
struct StressAnswer {
  Row row;
  StressCounts counts;

  [[nodiscard]] std::int64_t wrong() const { return row.false_hits + row.false_misses + row.wrong_root; }
  [[nodiscard]] std::int64_t right() const {
    return row.rays - wrong() - row.undecided - row.undecided_reference;
  }
  [[nodiscard]] std::int64_t count(Counted counted) const;
};

/// One expectation as a sentence, and what broke it: nothing where it holds.
struct StressOutcome {
  std::string expected, broken;
};

struct StressResult {
  std::string name, stresses;
  std::vector<StressAnswer> answers;
  std::vector<StressOutcome> outcomes;
  [[nodiscard]] bool as_expected() const;
};

/// Times are of one run on one thread. Throws InputError for what cannot be built.
[[nodiscard]] StressResult run_stress(const StressCase& stress, const StressOptions& options);
[[nodiscard]] StressResult run_stress(const StressFamily& family, const StressOptions& options);

/// Of every expectation, the two that every case has in front.
[[nodiscard]] std::vector<StressOutcome> outcomes_of(const std::vector<Expectation>& expected,
                                                     const std::vector<StressAnswer>& answers);

}  // namespace isocast::bench
