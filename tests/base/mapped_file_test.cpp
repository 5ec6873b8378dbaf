#include <fcntl.h>
#include <input_error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/output_file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <temporary_folder.h>
#include <unistd.h>

#include <csignal>
#include <numeric>
#include <thread>
#include <vector>

using namespace isocast;
using test::says;
using test::TemporaryFolder;

namespace {

// Reads every page.
int sum_of(const MappedFile& file) {
  return std::accumulate(file.bytes.begin(), file.bytes.end(), 0,
                         [](int sum, std::byte b) { return sum + static_cast<int>(b); });
}

}  // namespace

TEST_CASE("a mapped file gives its bytes, also after its name is gone") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", "bytes");
  const MappedFile file = map_file(folder / "a");
  std::filesystem::remove(folder / "a");
  REQUIRE(file.bytes.size() == 5);
  CHECK(static_cast<char>(file.bytes[0]) == 'b');
  CHECK(static_cast<char>(file.bytes[4]) == 's');
}

TEST_CASE("an empty file maps to an empty span") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", "");
  CHECK(map_file(folder / "a").bytes.empty());
}

TEST_CASE("what cannot be mapped gets one sentence with its path") {
  const TemporaryFolder folder;
  const std::string path = folder.path.string();
  CHECK_THROWS_MATCHES(map_file(folder / "none"), InputError,
                       says("cannot read " + path + "/none: No such file or directory"));
  CHECK_THROWS_MATCHES(map_file(folder.path), InputError,
                       says("cannot read " + path + ": it is a folder, a file was expected"));
  CHECK_THROWS_MATCHES(map_file("/dev/null"), InputError,
                       says("cannot read /dev/null: it is not a regular file"));

  // A pipe without a writer does not make the reader wait.
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_MATCHES(map_file(folder / "pipe"), InputError, says("pipe: it is not a regular file"));
}

TEST_CASE("a file that shrinks while it is mapped is told, its lost bytes read as zeros") {
  const TemporaryFolder folder;
  constexpr int kSize = 100000, kLeft = 5000;
  write_text_file(folder / "a", std::string(kSize, '\1'));
  write_text_file(folder / "b", std::string(kSize, '\1'));
  const MappedFile kept = map_file(folder / "b");
  {
    const MappedFile file = map_file(folder / "a");
    CHECK(sum_of(file) == kSize);
    CHECK_NOTHROW(check_mapped_files());
    std::filesystem::resize_file(folder / "a", kLeft);

    // many threads meet the lost pages at once
    std::vector<int> sums(8);
    {
      std::vector<std::jthread> threads;
      for (int& sum : sums) threads.emplace_back([&] { sum = sum_of(file); });
    }
    CHECK(sums == std::vector(sums.size(), kLeft));
    const auto told = says("a shrank while it was in use, expected its 100000 bytes to stay");
    CHECK_THROWS_MATCHES(check_mapped_files(), InputError, told);

    // zeros that were read stay worth nothing when the file grows again
    std::filesystem::resize_file(folder / "a", kSize);
    CHECK_THROWS_MATCHES(check_mapped_files(), InputError, told);
  }
  CHECK_NOTHROW(check_mapped_files());
  CHECK(sum_of(kept) == kSize);
}

TEST_CASE("a file that loses less than a page is told too") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", std::string(1000, '\1'));
  const MappedFile file = map_file(folder / "a");
  std::filesystem::resize_file(folder / "a", 999);
  CHECK_THROWS_MATCHES(check_mapped_files(), InputError, says("a shrank"));
}

TEST_CASE("mappings leave their places to later ones") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", "bytes");
  for (int i = 0; i < 3000; ++i) REQUIRE(map_file(folder / "a").bytes.size() == 5);
}

#ifndef ISOCAST_SANITIZE  // sanitizers end the process in their own way
TEST_CASE("a bus error outside mapped files ends the process as ever") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", "bytes");
  const MappedFile file = map_file(folder / "a");
  const auto ends_by_bus_error = [](auto cause) {
    const pid_t child = fork();
    if (child == 0) {
      cause();
      _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGBUS;
  };
  CHECK(ends_by_bus_error([] { raise(SIGBUS); }));
  CHECK(ends_by_bus_error([&] {
    // a mapping that is none of ours
    const int other = open((folder / "a").c_str(), O_RDONLY);
    const auto* pages = static_cast<const volatile char*>(mmap(nullptr, 5, PROT_READ, MAP_SHARED, other, 0));
    std::filesystem::resize_file(folder / "a", 0);
    (void)pages[0];
  }));
}
#endif
