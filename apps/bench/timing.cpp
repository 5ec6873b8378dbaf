#include <isocast/apps/bench/rows.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/base/interrupt.h>

#include <chrono>
#include <cmath>

namespace isocast::bench {

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates, int repetitions) {
  using Clock = std::chrono::steady_clock;
  for (const auto& candidate : candidates) candidate();

  std::vector<std::vector<double>> seconds(candidates.size());
  for (int i = 0; i < repetitions; ++i) {
    throw_if_interrupted();
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const Clock::time_point start = Clock::now();
      candidates[c]();
      seconds[c].push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
  }

  std::vector<Timing> timings;
  for (std::vector<double>& samples : seconds) {
    const double median = quantile(samples, 0.5);
    for (double& sample : samples) sample = std::abs(sample - median);
    timings.push_back({median, quantile(samples, 0.5)});
  }
  return timings;
}

}  // namespace isocast::bench
