// Runs `isocast info` on a sample of a corpus: exit code, one sentence, memory, time.
// usage: hostile_program FOLDER PROGRAM
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <temporary_folder.h>
#include <test_size.h>
#include <unistd.h>

#include <cstdio>

#include "corpus.h"

namespace isocast::hostile {
namespace {

struct End {
  int status;
  double seconds;        // of computing, children included
  std::uint64_t memory;  // the most that it or one of its children had, in bytes
  std::string error;
};

End run(const std::string& program, const std::string& file, const std::string& errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const char* const words[] = {program.c_str(), "info", file.c_str(), nullptr};
  pid_t process = -1;
  const int failed =
      posix_spawn(&process, program.c_str(), &actions, nullptr, const_cast<char**>(words), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) return {-1, 0, 0, "cannot start " + program};
  int status = 0;
  rusage used = {};
  wait4(process, &status, 0, &used);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, seconds(used.ru_utime) + seconds(used.ru_stime),
          static_cast<std::uint64_t>(used.ru_maxrss) * 1024, bytes_of(errors)};
}

std::string fault_of(const End& end, const Corpus::File& file) {
  constexpr double kMostSeconds = 10;
  constexpr std::uint64_t kMostMemory = 256'000'000;
  if (end.status != 2 && end.status != 0) return "exit code " + std::to_string(end.status);
  if (end.seconds > kMostSeconds) return std::to_string(end.seconds) + " s";
  if (end.memory > 2 * std::filesystem::file_size(file.path) + kMostMemory)
    return std::to_string(end.memory / 1'000'000) + " MB";
  if ((end.status == 0) != end.error.empty())
    return "exit code " + std::to_string(end.status) + ": " + end.error;
  if (end.status == 0) return fault_of_answer(file.expected, "");
  if (!end.error.starts_with("isocast: ") || !end.error.ends_with('\n')) return "no line: " + end.error;
  return fault_of_answer(file.expected, end.error.substr(0, end.error.size() - 1));
}

int run_all(const std::filesystem::path& folder, const std::string& program, std::uint64_t mutants) {
  const Corpus corpus(folder);
  const test::TemporaryFolder scratch;
  const std::filesystem::path errors = scratch / "errors.txt";
  std::filesystem::copy(folder / "whole", scratch.path);
  const std::uint64_t end = corpus.fixed_count() + mutants * corpus.whole_count();
  int faults = 0;
  std::uint64_t runs = 0;
  for (std::uint64_t n = 0; n < end; ++n) {
    const Corpus::File file = corpus.file(n, scratch.path);
    const std::string name = file.path.filename();
    if (name.starts_with("is_")) continue;
    ++runs;
    const std::string fault = fault_of(run(program, file.path, errors), file);
    if (fault.empty()) continue;
    std::printf("file %llu, %s: %s\n", static_cast<unsigned long long>(n), name.c_str(), fault.c_str());
    ++faults;
  }
  std::printf("%llu runs, %d faults\n", static_cast<unsigned long long>(runs), faults);
  return faults > 0;
}

}  // namespace
}  // namespace isocast::hostile

int main(int, char** words) {
  return isocast::hostile::run_all(words[1], words[2],
                                   static_cast<std::uint64_t>(isocast::test::cases(6, 120)));
}
