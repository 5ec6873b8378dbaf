// The suite `stability`: what can break ray tracing of iso-surfaces, with what is expected of every method.
#pragma once

#include <isocast/apps/bench/stress_run.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// All families of cells, volumes (written to folder/volumes) and formulas. Stops at Ctrl-C.
[[nodiscard]] std::vector<StressResult> run_stability(const StressOptions& options,
                                                      const std::filesystem::path& folder);

[[nodiscard]] std::vector<Row> rows_of(const std::vector<StressResult>& results);

/// A line for each case that is not as expected, and a last one that counts them.
[[nodiscard]] std::string stability_summary(const std::vector<StressResult>& results);

}  // namespace isocast::bench
