#include <fcntl.h>
#include <fmt/format.h>
#include <isocast/base/child_process.h>
#include <isocast/base/interrupt.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace isocast {
namespace {

[[noreturn]] void fail(const std::filesystem::path& program, int error) {
  throw std::runtime_error(fmt::format("cannot start {}: {}", program.string(), std::strerror(error)));
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           std::span<const int> inherited) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail(program, errno);
  channel_ = ends[0];

  // its descriptors are moved out of the way of each other first
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  std::vector<int> moved;
  for (const int fd : inherited) moved.push_back(fcntl(fd, F_DUPFD_CLOEXEC, 64));
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  for (std::size_t i = 0; i < moved.size(); ++i)
    posix_spawn_file_actions_adddup2(&actions, moved[i], static_cast<int>(3 + i));

  // signals as a program expects them: this process may block some
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);

  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv = {name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int error = posix_spawn(&process_, name.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  for (const int fd : moved) close(fd);
  close(ends[1]);
  if (error == 0) return;
  close(channel_);
  fail(program, error);
}

ChildProcess::~ChildProcess() {
  if (channel_ >= 0) close(channel_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool ChildProcess::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(channel_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

ChildProcess::End ChildProcess::finish() {
  constexpr std::size_t kLongest = 65536;
  shutdown(channel_, SHUT_WR);
  End end{0, {}};
  char buffer[4096];
  for (;;) {
    const ssize_t got = recv(channel_, buffer, sizeof buffer, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    if (end.message.size() < kLongest) end.message.append(buffer, static_cast<std::size_t>(got));
  }
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
  process_ = -1;
  throw_if_interrupted();
  end.status = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

void limit_this_process(std::size_t memory, unsigned seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit cpu = {seconds, seconds};
  setrlimit(RLIMIT_CPU, &cpu);
#if !defined(ISOCAST_SANITIZE)  // its shadow memory counts as private
  const rlimit data = {memory, memory};
  setrlimit(RLIMIT_DATA, &data);
#else
  static_cast<void>(memory);
#endif
}

}  // namespace isocast
