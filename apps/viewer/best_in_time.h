// The best picture that there is when its time is over.
#pragma once

#include <isocast/apps/viewer/wish.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace isocast::viewer {

/// Pictures of one wish, each better than the one before, of which the last that is there at the end of the
/// frame budget is shown. Those that come later are shown as they come.
class BestInTime {
 public:
  /// show: by one thread at a time, at the end one of its own; over: after that, at the end.
  BestInTime(Clock::time_point end, std::function<void(Picture)> show, std::function<void()> over);

  /// Keeps a picture for the end, or shows it when that is over.
  void keep(Picture picture);
  /// Shows a picture at once, and nothing at the end.
  void show_now(Picture picture);

 private:
  Clock::time_point end_;
  std::function<void(Picture)> show_;
  std::mutex mutex_;
  std::condition_variable_any bell_;  // never rung: for its wait that can be stopped
  std::optional<Picture> kept_;
  std::jthread timer_;
};

}  // namespace isocast::viewer
