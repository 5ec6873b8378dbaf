#include <fcntl.h>
#include <isocast/base/progress.h>
#include <pty.h>
#include <temporary_folder.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <thread>

using namespace isocast;
using std::chrono::milliseconds;

namespace {

// Counts past the second after which a bar is drawn, with stderr going to `file`.
void work_with_stderr(int file) {
  const int before = dup(STDERR_FILENO);
  dup2(file, STDERR_FILENO);
  {
    Progress progress("work", 4);
    progress.add(1);
    std::this_thread::sleep_for(milliseconds(1050));
    progress.add(2);
  }
  dup2(before, STDERR_FILENO);
  close(before);
}

}  // namespace

TEST_CASE("progress is silent when stderr is no terminal") {
  const test::TemporaryFolder folder;
  const int file = open((folder / "stderr").c_str(), O_CREAT | O_WRONLY, 0600);
  REQUIRE(file >= 0);
  work_with_stderr(file);
  close(file);
  CHECK(test::bytes_of(folder / "stderr").empty());
}

TEST_CASE("progress draws a bar on a terminal and clears it") {
  int terminal = -1, program = -1;
  if (openpty(&terminal, &program, nullptr, nullptr, nullptr) != 0) {
    WARN("this system has no pseudo-terminals: the bar was not tested");
    return;
  }
  work_with_stderr(program);
  char shown[1024];
  const ssize_t size = read(terminal, shown, sizeof(shown));
  close(program);
  close(terminal);
  REQUIRE(size > 0);
  const std::string text(shown, static_cast<std::size_t>(size));
  CHECK(text == "\rwork [" + std::string(30, '#') + std::string(10, '.') + "]  75 %\r\033[K");
}

TEST_CASE("a watch is told of the latest work instead of the terminal") {
  ProgressWatch watch;
  CHECK(watch.work().share == 0);
  Progress first("first", 4);
  first.add(3);
  CHECK(watch.work().what == "first");
  CHECK(watch.work().share == 0.75);
  Progress second("second", 10);
  CHECK(watch.work().what == "second");
  CHECK(watch.work().share == 0);
  second.add(100);
  CHECK(watch.work().share == 1);
  CHECK(first.done() == 3);
}
