#include <fmt/format.h>
#include <isocast/apps/bench/stability.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/progress.h>

#include <algorithm>

namespace isocast::bench {

std::vector<StressResult> run_stability(const StressOptions& options, const std::filesystem::path& folder) {
  const std::vector<StressFamily> families = stress_families();
  const std::vector<StressCase> volumes = stress_volumes(folder), formulas = stress_formulas();
  std::vector<StressResult> results;
  Progress progress("bench stability", std::ssize(families) + std::ssize(volumes) + std::ssize(formulas));
  const auto run_all = [&](const auto& cases) {
    for (const auto& one : cases) {
      throw_if_interrupted();
      results.push_back(run_stress(one, options));
      progress.add();
    }
  };
  run_all(families);
  run_all(volumes);
  run_all(formulas);
  return results;
}

std::vector<Row> rows_of(const std::vector<StressResult>& results) {
  std::vector<Row> rows;
  for (const StressResult& result : results)
    for (const StressAnswer& answer : result.answers) rows.push_back(answer.row);
  return rows;
}

std::string stability_summary(const std::vector<StressResult>& results) {
  std::string text;
  for (const StressResult& result : results)
    for (const StressOutcome& outcome : result.outcomes)
      if (!outcome.broken.empty())
        text += fmt::format("{}: NOT AS EXPECTED: {} (found {})\n", result.name, outcome.expected,
                            outcome.broken);
  const auto good = std::ranges::count_if(results, &StressResult::as_expected);
  return text + fmt::format("{} of {} cases as expected\n", good, results.size());
}

}  // namespace isocast::bench
