#include <dlfcn.h>
#include <input_error.h>
#include <isocast/base/module.h>
#include <isocast/base/output_file.h>

#include <filesystem>

using namespace isocast;
using test::says;
namespace fs = std::filesystem;

namespace {

// A file among the modules, for the time of a test.
struct FalseModule {
  fs::path path;
  explicit FalseModule(const std::string& name)
      : path(fs::path(ISOCAST_MODULE_DIR) / ("isocast_" + name + ".so")) {
    fs::create_directories(path.parent_path());
    fs::remove(path);
  }
  ~FalseModule() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
};

}  // namespace

TEST_CASE("a module that was not built is named, with what needs it") {
  CHECK_THROWS_MATCHES(open_module("nothing", "a.xyz"), InputError,
                       says("a.xyz needs the module 'nothing', which this build does not have"));
}

TEST_CASE("a module that cannot be loaded says why") {
  const FalseModule module("test_broken");
  write_text_file(module.path, "no library");
  CHECK_THROWS_MATCHES(
      open_module("test_broken", "a.xyz"), InputError,
      says("a.xyz needs the module 'test_broken', which cannot be loaded: " + module.path.string()));
}

TEST_CASE("a library that is no module is refused") {
  const FalseModule module("test_foreign");
  Dl_info library;
  REQUIRE(dladdr(reinterpret_cast<void*>(&dladdr), &library));
  fs::create_symlink(library.dli_fname, module.path);
  CHECK_THROWS_MATCHES(
      open_module("test_foreign", "a.xyz"), InputError,
      says("a.xyz needs the module 'test_foreign', but " + module.path.string() + " is not one"));
}
