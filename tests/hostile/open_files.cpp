// Opens every file of a corpus with the readers under sanitizers, looks at all its samples and sends rays
// through it. usage: hostile_open FOLDER [MUTANTS], MUTANTS of each whole file
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/volume/io/vdb_header.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <temporary_folder.h>
#include <test_size.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "corpus.h"
#include "open_volume.h"

namespace isocast::hostile {
namespace {

// What is wrong with how the readers met a file; empty if nothing is.
std::string fault_of(const Corpus::File& file) {
  std::string error;
  try {
    open_volume(file.path);
  } catch (const InputError& e) { error = e.what(); } catch (const std::exception& e) {
    return std::string("another failure: ") + e.what();
  }
  return fault_of_answer(file.expected, error);
}

// OpenVDB has a process of its own, without sanitizers: what is ours of it is looked at here.
void read_header_of(const std::filesystem::path& path) {
  try {
    (void)read_vdb_header(map_file(path).bytes);
  } catch (const std::runtime_error&) {}
}

// Where a process that opens files is: shared with the one that watches it.
struct Progress {
  std::uint64_t next;
  int faults;
};

// A file that crashes or hangs ends the process at its number.
void open_from(const Corpus& corpus, std::uint64_t end, const std::filesystem::path& scratch,
               Progress& progress) {
  constexpr unsigned kMostSeconds = 60;
  constexpr std::uint64_t kProcesses = 8;  // of so many .vdb files one is sent to OpenVDB
  for (; progress.next < end; ++progress.next) {
    const Corpus::File file = corpus.file(progress.next, scratch);
    alarm(kMostSeconds);
    const bool vdb = file.path.extension() == ".vdb";
    if (vdb) read_header_of(file.path);
    if (vdb && progress.next >= corpus.fixed_count() && progress.next % kProcesses != 0) continue;
    const std::string fault = fault_of(file);
    if (fault.empty()) continue;
    fmt::print("file {}, {}: {}\n", progress.next, file.path.filename().string(), fault);
    ++progress.faults;
  }
}

int run(const std::filesystem::path& folder, std::uint64_t mutants) {
  const Corpus corpus(folder);
  const test::TemporaryFolder scratch;
  std::filesystem::copy(folder / "whole", scratch.path);
  auto& progress = *static_cast<Progress*>(
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  const std::uint64_t end = corpus.fixed_count() + mutants * corpus.whole_count();
  for (; progress.next < end; ++progress.next) {
    std::fflush(stdout);
    const pid_t process = fork();
    if (process == 0) {
      open_from(corpus, end, scratch.path, progress);
      std::fflush(stdout);
      _exit(0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    if (status == 0) break;
    fmt::print("file {}: ended with status {:#x}\n", progress.next, status);
    ++progress.faults;
  }
  fmt::print("{} files opened or refused, {} faults\n", progress.next, progress.faults);
  return progress.faults > 0;
}

}  // namespace
}  // namespace isocast::hostile

int main(int count, char** words) {
  const std::uint64_t mutants =
      count > 2 ? std::stoull(words[2]) : static_cast<std::uint64_t>(isocast::test::cases(80, 1600));
  return isocast::hostile::run(words[1], mutants);
}
