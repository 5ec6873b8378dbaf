// A progress bar on stderr for work over a second, on a terminal only.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace isocast {

/// Counts units of work from any number of threads and draws a bar once a second of work has passed and
/// stderr is a terminal. The destructor clears the line.
class Progress {
 public:
  Progress(std::string what, std::int64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void add(std::int64_t units = 1);
  [[nodiscard]] std::int64_t done() const { return done_; }

 private:
  void draw(std::int64_t done);

  std::string what_;
  std::int64_t total_;
  std::atomic<std::int64_t> done_ = 0;
  std::chrono::steady_clock::time_point start_, last_;
  std::mutex mutex_;
  bool terminal_ = false, drawn_ = false;
};

/// While one lives, the work of this process is told to it and nothing is drawn; one at a time. Its calls may
/// come from any thread and never wait for work.
class ProgressWatch {
 public:
  ProgressWatch();
  ~ProgressWatch();
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;

  /// The latest work that began, and the share of it that is done, 0 to 1.
  struct Work {
    std::string what;
    double share = 0;
  };
  [[nodiscard]] Work work() const;

 private:
  friend class Progress;
  mutable std::mutex mutex_;
  std::string what_;
  std::atomic<std::int64_t> done_ = 0, total_ = 1;
};

}  // namespace isocast
