// What the render loop has done, for --stats and the tests.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace isocast::viewer {

/// Milliseconds from wishes to pictures.
class Latencies {
 public:
  void add(double ms) {
    const std::lock_guard lock(mutex_);
    if (all_.size() < kMost) all_.push_back(ms);
  }
  [[nodiscard]] std::vector<double> all() const {
    const std::lock_guard lock(mutex_);
    return all_;
  }

 private:
  static constexpr std::size_t kMost = 100000;
  mutable std::mutex mutex_;
  std::vector<double> all_;
};

/// Written by the render thread, read by any.
///
/// pictures            by stage
/// tiles_rendered      of all pictures, tiles_cancelled: of pictures that were ended, those not begun
/// cancelled           pictures that were ended, and of these: tiles that were still finished after the end
///                     was wanted, at most (no more than threads), and the longest time that took
/// first, complete     from wishes to their first and to their last pictures
/// late_previews       wishes whose first picture was not there at their budget's end
struct LoopCounts {
  std::array<std::atomic<std::int64_t>, 4> pictures = {};
  std::atomic<std::int64_t> tiles_rendered = 0, tiles_cancelled = 0, cancelled = 0, late_previews = 0;
  std::atomic<std::int64_t> tiles_after_end = 0;
  std::atomic<double> longest_end_ms = 0, longest_preview_ms = 0;
  std::atomic<std::int64_t> scenes = 0;
  Latencies first, complete;
};

}  // namespace isocast::viewer
