#include <fmt/format.h>
#include <isocast/base/progress.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace isocast {
using std::chrono::milliseconds;
using std::chrono::steady_clock;

namespace {

std::atomic<ProgressWatch*> watch = nullptr;

}  // namespace

ProgressWatch::ProgressWatch() { watch = this; }
ProgressWatch::~ProgressWatch() { watch = nullptr; }

ProgressWatch::Work ProgressWatch::work() const {
  const std::lock_guard lock(mutex_);
  return {what_, std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_))};
}

Progress::Progress(std::string what, std::int64_t total)
    : what_(std::move(what)),
      total_(std::max<std::int64_t>(total, 1)),
      start_(steady_clock::now()),
      last_(start_),
      terminal_(!watch && isatty(STDERR_FILENO) == 1) {
  if (ProgressWatch* const told = watch) {
    const std::lock_guard lock(told->mutex_);
    told->what_ = what_;
    told->done_ = 0;
    told->total_ = total_;
  }
}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void Progress::add(std::int64_t units) {
  const std::int64_t done = done_ += units;
  if (ProgressWatch* const told = watch) told->done_ = done;
  if (!terminal_ || !mutex_.try_lock()) return;
  draw(done);
  mutex_.unlock();
}

void Progress::draw(std::int64_t done) {
  const auto now = steady_clock::now();
  if (now - start_ < milliseconds(1000) || now - last_ < milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  constexpr int kWidth = 40;
  const double fraction = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const int full = static_cast<int>(fraction * kWidth);
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %", what_, "", full, "", kWidth - full, 100 * fraction);
  std::fflush(stderr);
}

}  // namespace isocast
