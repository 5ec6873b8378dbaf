// Run times of several candidates, taken in turns so that drift of the machine hits all alike.
#pragma once

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

/// Runs every candidate once unmeasured, then all of them in turn `repetitions` times. Stops at Ctrl-C.
[[nodiscard]] std::vector<Timing> time_interleaved(const std::vector<std::function<void()>>& candidates,
                                                   int repetitions, Clock clock);

}  // namespace isocast::bench
