// Run times of several candidates, taken in turns so that drift of the machine hits all alike.
#pragma once

#include <isocast/apps/bench/rows.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace isocast::bench {

/// Median of the repetitions and median absolute deviation from it, both in seconds.
struct Timing {
  double seconds, mad;
};

/// wall: what a user waits. thread: the processor time of the calling thread, for work that has one thread;
/// what else runs on the machine then counts little.
enum class Clock { wall, thread };
/// Seconds since some moment.
using ReadClock = std::function<double()>;
[[nodiscard]] ReadClock clock_of(Clock clock);

/// How often every candidate is measured: as often as fits into `seconds` of wall time, by the unmeasured
/// runs, but `least` to `most` times.
struct Repetitions {
  int least, most;
  double seconds;

  Repetitions(int exactly) : least(exactly), most(exactly), seconds(0) {}
  Repetitions(int at_least, int at_most, double budget) : least(at_least), most(at_most), seconds(budget) {}
};

/// Runs every candidate once unmeasured, then all of them in turn. `prepare`, where there is one, is called
/// with a candidate's number before each of its runs, and not measured. Stops at Ctrl-C.
[[nodiscard]] std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates,
                                                   const Repetitions& repetitions, Clock clock,
                                                   const std::function<void(std::size_t)>& prepare = {});
/// The same with a clock for each candidate, by its number.
[[nodiscard]] std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates,
                                                   const Repetitions& repetitions,
                                                   const std::function<ReadClock(std::size_t)>& clock,
                                                   const std::function<void(std::size_t)>& prepare);

/// The columns that hold times, of a row whose rays are counted.
void set_timing(Row& row, const Timing& timing);

}  // namespace isocast::bench
