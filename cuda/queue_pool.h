// Queues with the memory that their work needs, kept for the next one.
#pragma once

#include <isocast/cuda/engine.h>

#include <mutex>
#include <vector>

namespace isocast {

/// A queue and the buffers of its work, which grow as needed.
class Workplace {
 public:
  explicit Workplace(const Engine& engine) : engine_(engine), queue(engine.make_queue()) {}
  /// At least so many bytes for purpose `i`, from one piece of work to the next.
  [[nodiscard]] std::byte* buffer(std::size_t i, std::size_t bytes) {
    if (i >= buffers_.size()) buffers_.resize(i + 1);
    if (!buffers_[i] || buffers_[i]->bytes() < bytes) {
      buffers_[i].reset();
      buffers_[i] = engine_.allocate(bytes);
    }
    return static_cast<std::byte*>(buffers_[i]->data());
  }

 private:
  const Engine& engine_;
  std::vector<std::unique_ptr<KernelMemory>> buffers_;

 public:
  const std::unique_ptr<Queue> queue;
};

/// One workplace for each thread that works at a time.
class QueuePool {
 public:
  explicit QueuePool(std::shared_ptr<const Engine> engine) : engine_(std::move(engine)) {}
  [[nodiscard]] const Engine& engine() const { return *engine_; }

  /// work(Workplace&), then waits for its queue. What throws on the way loses the workplace.
  template <class Work> void with_workplace(Work work) const {
    std::unique_ptr<Workplace> place = take();
    work(*place);
    const double seconds = place->queue->wait();
    const std::scoped_lock lock(mutex_);
    seconds_ += seconds;
    free_.push_back(std::move(place));
  }
  /// Of all launches so far, by the device's clock.
  [[nodiscard]] double seconds() const {
    const std::scoped_lock lock(mutex_);
    return seconds_;
  }

 private:
  [[nodiscard]] std::unique_ptr<Workplace> take() const {
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<Workplace> place = std::move(free_.back());
        free_.pop_back();
        return place;
      }
    }
    return std::make_unique<Workplace>(*engine_);
  }

  std::shared_ptr<const Engine> engine_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Workplace>> free_;
  mutable double seconds_ = 0;
};

}  // namespace isocast
