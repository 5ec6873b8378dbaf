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

 private:
  void draw(std::int64_t done);

  std::string what_;
  std::int64_t total_;
  std::atomic<std::int64_t> done_ = 0;
  std::chrono::steady_clock::time_point start_, last_;
  std::mutex mutex_;
  bool terminal_ = false, drawn_ = false;
};

}  // namespace isocast
