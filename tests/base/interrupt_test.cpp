#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>

using namespace isocast;

namespace {

// A process that is interrupted twice: 130 comes from the second signal, anything else is a failure.
[[noreturn]] void interrupted_process() {
  const std::stop_token token = interrupt_token();
  kill(getpid(), SIGINT);
  while (!token.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  try {
    throw_if_interrupted();
  } catch (const Interrupted&) {
    kill(getpid(), SIGTERM);
    while (true) pause();
  }
  _exit(1);
}

}  // namespace

TEST_CASE("the first signal asks to stop, the second ends the process") {
  const pid_t process = fork();
  REQUIRE(process >= 0);
  if (process == 0) interrupted_process();
  int status = 0;
  REQUIRE(waitpid(process, &status, 0) == process);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);
}

TEST_CASE("unwanted work is interrupted, and only that") {
  CHECK_NOTHROW(throw_if_interrupted());
  std::stop_source source;
  {
    const InterruptibleWork work(source.get_token());
    CHECK_NOTHROW(throw_if_interrupted());
    source.request_stop();
    CHECK_THROWS_AS(throw_if_interrupted(), Interrupted);
  }
  CHECK_NOTHROW(throw_if_interrupted());
}
