#include <isocast/apps/viewer/best_in_time.h>

#include <utility>

namespace isocast::viewer {

BestInTime::BestInTime(Clock::time_point end, std::function<void(Picture)> show, std::function<void()> over)
    : end_(end), show_(std::move(show)), timer_([this, over = std::move(over)](std::stop_token gone) {
        {
          std::unique_lock lock(mutex_);
          bell_.wait_until(lock, gone, end_, [] { return false; });
          if (gone.stop_requested()) return;
          if (kept_) show_(*std::exchange(kept_, {}));
        }
        over();
      }) {}

void BestInTime::keep(Picture picture) {
  const std::lock_guard lock(mutex_);
  if (Clock::now() >= end_) show_(std::move(picture));
  else kept_ = std::move(picture);
}

void BestInTime::show_now(Picture picture) {
  const std::lock_guard lock(mutex_);
  kept_.reset();
  show_(std::move(picture));
}

}  // namespace isocast::viewer
