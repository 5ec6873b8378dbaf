// Where the interface leaves its newest wish for the render thread: neither ever waits for the other's work.
#pragma once

#include <isocast/apps/viewer/wish.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace isocast::viewer {

/// Work that is going on. Before `stays_until` a newer wish does not end it: a preview is worth showing.
struct RunningWork {
  std::stop_source stop;
  std::uint64_t revision = 0;
  Clock::time_point stays_until;
};
/// When work was stopped, and its tiles that were done once the stop could be seen.
struct StopMoment {
  Clock::time_point time;
  std::int64_t tiles = 0;
};
inline constexpr Clock::time_point kStays = Clock::time_point::max();  // only end_now() ends it

/// put() is the interface's, nudge() and end_now() any thread's, the others the render thread's.
class Mailbox {
 public:
  /// Replaces the wish before, and stops what works on an older one.
  void put(std::shared_ptr<const Wish> wish);
  /// Stops work that newer wishes have waited long enough for; to be called when that time is over.
  void nudge();
  /// Stops what is going on, whatever it is; `before`: only for a wish that is older.
  void end_now(std::uint64_t before = ~std::uint64_t(0));
  /// Stops everything, for good.
  void close();

  /// The newest wish, if any; sleeps until there is one after `revision`, wake() or close().
  [[nodiscard]] std::shared_ptr<const Wish> wait_for_newer(std::uint64_t revision);
  /// Wakes the render thread without a wish.
  void wake();
  [[nodiscard]] bool has_newer(std::uint64_t revision) const { return revision_ > revision; }
  [[nodiscard]] bool closed() const { return closed_; }

  /// Registers work on a wish for as long as it lives. progress may be null; it counts tiles.
  class Work {
   public:
    Work(Mailbox& mailbox, std::uint64_t revision, Clock::time_point stays_until,
         const Progress* progress = nullptr);
    ~Work() { mailbox_.running_.store(nullptr); }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    [[nodiscard]] std::stop_token stop() const { return running_->stop.get_token(); }
    /// Of work that was stopped; it is recorded by whoever stops it, for whose few instructions this waits.
    [[nodiscard]] const StopMoment& stopped() {
      record_.reset();
      return stopped_;
    }

   private:
    Mailbox& mailbox_;
    std::shared_ptr<RunningWork> running_;
    StopMoment stopped_;
    std::optional<std::stop_callback<std::function<void()>>> record_;
  };

 private:
  std::atomic<std::shared_ptr<const Wish>> wish_;
  std::atomic<std::shared_ptr<RunningWork>> running_;
  std::atomic<std::uint64_t> revision_ = 0, worked_on_ = 0;
  std::atomic<std::uint32_t> bell_ = 0;
  std::uint32_t heard_ = 0;  // the render thread's
  std::atomic<bool> closed_ = false;
};

}  // namespace isocast::viewer
