#include <isocast/apps/viewer/mailbox.h>

namespace isocast::viewer {

void Mailbox::put(std::shared_ptr<const Wish> wish) {
  const std::uint64_t revision = wish->revision;
  wish_.store(std::move(wish));
  revision_ = revision;
  nudge();
  wake();
}

void Mailbox::nudge() {
  if (!closed_ && revision_ <= worked_on_) return;
  const std::shared_ptr<RunningWork> running = running_.load();
  if (running && (closed_ || Clock::now() >= running->stays_until)) running->stop.request_stop();
}

void Mailbox::end_now(std::uint64_t before) {
  const std::shared_ptr<RunningWork> running = running_.load();
  if (running && running->revision < before) running->stop.request_stop();
}

void Mailbox::close() {
  closed_ = true;
  nudge();
  wake();
}

void Mailbox::wake() {
  ++bell_;
  bell_.notify_all();
}

std::shared_ptr<const Wish> Mailbox::wait_for_newer(std::uint64_t revision) {
  if (!has_newer(revision) && !closed_) bell_.wait(heard_);
  heard_ = bell_;
  return closed_ ? nullptr : wish_.load();
}

Mailbox::Work::Work(Mailbox& mailbox, std::uint64_t revision, Clock::time_point stays_until,
                    const Progress* progress)
    : mailbox_(mailbox), running_(std::make_shared<RunningWork>()) {
  running_->revision = revision;
  running_->stays_until = stays_until;
  record_.emplace(stop(), [this, progress] { stopped_ = {Clock::now(), progress ? progress->done() : 0}; });
  mailbox.worked_on_ = revision;
  mailbox.running_.store(running_);
  mailbox.nudge();
}

}  // namespace isocast::viewer
