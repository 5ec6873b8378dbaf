#include <isocast/apps/bench/timing.h>
#include <isocast/base/interrupt.h>

#include <algorithm>
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

ReadClock clock_of(Clock clock) {
  return [clock] { return seconds_now(clock); };
}

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates,
                                     const Repetitions& repetitions, Clock clock,
                                     const std::function<void(std::size_t)>& prepare) {
  return time_interleaved(
      candidates, repetitions, [clock](std::size_t) { return clock_of(clock); }, prepare);
}

std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates,
                                     const Repetitions& repetitions,
                                     const std::function<ReadClock(std::size_t)>& clock,
                                     const std::function<void(std::size_t)>& prepare) {
  std::vector<std::vector<double>> seconds(candidates.size());
  const auto measure_all = [&] {
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      throw_if_interrupted();
      if (prepare) prepare(c);
      const ReadClock now = clock(c);
      const double start = now();
      candidates[c]();
      seconds[c].push_back(now() - start);
    }
  };
  const double start = seconds_now(Clock::wall);
  measure_all();
  const double round = std::max(seconds_now(Clock::wall) - start, 1e-9);
  for (std::vector<double>& samples : seconds) samples.clear();

  const double fitting = std::min<double>(repetitions.seconds / round, repetitions.most);
  const int count = std::max(repetitions.least, static_cast<int>(fitting));
  for (int i = 0; i < count; ++i) measure_all();

  std::vector<Timing> timings;
  for (std::vector<double>& samples : seconds) {
    const double median = quantile(samples, 0.5);
    for (double& sample : samples) sample = std::abs(sample - median);
    timings.push_back({median, quantile(samples, 0.5)});
  }
  return timings;
}

void set_timing(Row& row, const Timing& timing) {
  row.seconds = timing.seconds;
  row.seconds_mad = timing.mad;
  row.mrays_per_s = timing.seconds > 0 ? 1e-6 * static_cast<double>(row.rays) / timing.seconds : 0;
}

}  // namespace isocast::bench
