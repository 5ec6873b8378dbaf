#include <input_error.h>
#include <isocast/base/output_file.h>
#include <temporary_folder.h>
#include <unistd.h>

using namespace isocast;
using test::bytes_of;
using test::says;
using test::TemporaryFolder;
namespace fs = std::filesystem;

TEST_CASE("an output file appears when it is committed, and not before") {
  const TemporaryFolder folder;
  {
    OutputFile file(folder / "a.txt");
    CHECK(file.target() == folder / "a.txt");
    CHECK(file.temporary().parent_path() == folder.path);
    CHECK(file.temporary().extension() == ".txt");
    std::ofstream(file.temporary()) << "whole";
    CHECK_FALSE(fs::exists(folder / "a.txt"));
    file.commit();
    CHECK(bytes_of(folder / "a.txt") == "whole");
  }
  CHECK(bytes_of(folder / "a.txt") == "whole");
  CHECK(folder.entries() == 1);
}

TEST_CASE("an output file that is given up leaves what was there") {
  const TemporaryFolder folder;
  write_text_file(folder / "a.txt", "old");
  try {
    const OutputFile file(folder / "a.txt");
    std::ofstream(file.temporary()) << "half";
    CHECK(folder.entries() == 2);
    throw std::runtime_error("in the middle");
  } catch (const std::runtime_error&) {}
  CHECK(bytes_of(folder / "a.txt") == "old");
  CHECK(folder.entries() == 1);

  // A rename that fails counts as given up.
  OutputFile file(folder / "b.txt");
  CHECK_THROWS_MATCHES(file.commit(), InputError,
                       says("cannot write " + (folder / "b.txt").string() + ": No such file"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("places where no file can be written get one sentence") {
  const TemporaryFolder folder;
  const std::string path = folder.path.string();
  CHECK_THROWS_MATCHES(
      OutputFile(folder / "none/a.txt"), InputError,
      says("cannot write " + path + "/none/a.txt: the folder " + path + "/none does not exist"));
  CHECK_THROWS_MATCHES(OutputFile(folder.path), InputError,
                       says("cannot write " + path + ": it is a folder, a file name was expected"));
  write_text_file(folder / "file", "");
  CHECK_THROWS_MATCHES(OutputFile(folder / "file/a.txt"), InputError, says("file does not exist"));
  CHECK_THROWS_MATCHES(write_text_file("/proc/a.txt", "x"), InputError, says("cannot write /proc/a.txt"));

  // The superuser may write everywhere.
  fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
  if (geteuid() != 0)
    CHECK_THROWS_MATCHES(OutputFile(folder / "a.txt"), InputError, says("no permission to write in " + path));
  fs::permissions(folder.path, fs::perms::owner_all);
}

TEST_CASE("text files are written byte for byte, over what was there") {
  const TemporaryFolder folder;
  write_text_file(folder / "a", "first, and longer");
  const std::string text("a\r\n\0b", 5);
  write_text_file(folder / "a", text);
  CHECK(bytes_of(folder / "a") == text);

  // a bare name is in the current folder
  const fs::path before = fs::current_path();
  fs::current_path(folder.path);
  write_text_file("b", "here");
  fs::current_path(before);
  CHECK(bytes_of(folder / "b") == "here");
  CHECK(folder.entries() == 2);
}
