// A part of the program that runs as a process of its own, so that it may fail.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace isocast {

/// A running program. It reads what is sent from its stdin; what it writes to its stdout is its message.
class ChildProcess {
 public:
  /// Starts `program`; file descriptor inherited[i] is number 3 + i there. Throws std::runtime_error when it
  /// cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               std::span<const int> inherited);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// False when the process has stopped reading: finish() tells why.
  bool send(std::span<const std::byte> bytes);

  /// status   exit code, or minus the number of the signal that ended it
  /// message  at most 64 KB of it
  struct End {
    int status;
    std::string message;
  };
  /// Closes its stdin and waits for its end. Throws Interrupted after Ctrl-C.
  [[nodiscard]] End finish();

 private:
  pid_t process_ = -1;
  int channel_ = -1;
};

/// Memory that a process may take (private pages, in bytes) and the seconds it may compute; to be called by
/// a child before its work. Also ends it with its parent.
void limit_this_process(std::size_t memory, unsigned seconds);

}  // namespace isocast
