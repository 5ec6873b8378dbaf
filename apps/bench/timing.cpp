#include <isocast/apps/bench/rows.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/base/interrupt.h>

#include <cmath>
#include <ctime>

namespace isocast::bench {
namespace {

double seconds_now(Clock clock) {
  timespec now;
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates, int repetitions,
                                     Clock clock) {
  for (const auto& candidate : candidates) candidate();

  std::vector<std::vector<double>> seconds(candidates.size());
  for (int i = 0; i < repetitions; ++i) {
    throw_if_interrupted();
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const double start = seconds_now(clock);
      candidates[c]();
      seconds[c].push_back(seconds_now(clock) - start);
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
