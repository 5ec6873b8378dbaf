// The choice of a reader, and files that are none.
#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

TEST_CASE("the extension chooses the reader", "[io]") {
  const TemporaryFolder folder;
  CHECK_THAT(error_of(folder.write("a.txt", "x")),
             Contains("a.txt") && Contains("expected .raw .nrrd .nhdr .mhd .mha .nii .nii.gz .vti .vdb or .nvdb"));
  CHECK_THAT(error_of(folder.write("noextension", "x")), Contains("expected .raw"));
  CHECK_THAT(error_of(folder.write("a.gz", "x")), Contains("expected .raw"));
  ReadOptions grid;
  grid.grid = "density";
  for (const char* name : {"a.nrrd", "a_2x2x2_uint8.raw"})
    CHECK_THAT(error_of(folder.write(name, "x"), grid), Contains(".vdb and .nvdb files only"));
  CHECK_THAT(error_of(folder.write("a.nrrd", "x"), {{{2, 2, 2}}, {}}), Contains(".raw files only"));
  CHECK_THAT(error_of(folder.write("a.nii", "x"), {{}, {}, true}), Contains(".raw files only"));
}

TEST_CASE("what is no readable file is told in every format", "[io]") {
  const TemporaryFolder folder;
  for (const std::string name :
       {"a_2x2x2_uint8.raw", "a.nrrd", "a.nhdr", "a.mhd", "a.MHA", "a.nii", "a.nii.gz", "a.vti", "a.vdb", "a.NVDB"}) {
    INFO(name);
    CHECK_THAT(error_of(folder.path() / name), Contains(name) && Contains("there is no such file"));
    std::filesystem::create_directory(folder.path() / name);
    CHECK_THAT(error_of(folder.path() / name), Contains(name) && Contains("it is a folder"));
    std::filesystem::remove(folder.path() / name);
    CHECK_THAT(error_of(folder.write(name, "")), Contains(name));
    if (!name.ends_with(".raw")) CHECK_THAT(error_of(folder.write(name, noise(4096))), Contains(name));
    if (geteuid() == 0) continue;
    std::filesystem::permissions(folder.path() / name, std::filesystem::perms::none);
    CHECK_THAT(error_of(folder.path() / name), Contains("Permission denied"));
  }
}
