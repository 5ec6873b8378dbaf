#include <input_error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/output_file.h>
#include <sys/stat.h>
#include <temporary_folder.h>

using namespace isocast;
using test::says;
using test::TemporaryFolder;

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
