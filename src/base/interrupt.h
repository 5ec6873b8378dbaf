// Ctrl-C as a stop token, so that nothing is left half written.
#pragma once

#include <stop_token>

namespace isocast {

/// The token that the first Ctrl-C (or SIGTERM) triggers; the first call installs the handlers. A second
/// signal ends the process at once.
std::stop_token interrupt_token();

/// Throws Interrupted when Ctrl-C was pressed, or the work is unwanted.
void throw_if_interrupted();

/// While one lives, throw_if_interrupted() also throws, in any thread, once the token is stopped; one at a
/// time.
class InterruptibleWork {
 public:
  explicit InterruptibleWork(std::stop_token stop);
  ~InterruptibleWork();
  InterruptibleWork(const InterruptibleWork&) = delete;
  InterruptibleWork& operator=(const InterruptibleWork&) = delete;

 private:
  std::stop_token stop_;
};

}  // namespace isocast
