#include <dlfcn.h>
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/module.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

namespace isocast {
namespace fs = std::filesystem;

namespace {

// Beside the executable (build tree and installation alike), then where this library was built.
std::vector<fs::path> candidates(const std::string& name) {
  const std::string file = "isocast_" + name + ".so";
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> paths;
  if (!error) paths.push_back(executable.parent_path().parent_path() / ISOCAST_LIBDIR / "isocast" / file);
  paths.push_back(fs::path(ISOCAST_MODULE_DIR) / file);
  paths.push_back(fs::path(ISOCAST_INSTALL_MODULE_DIR) / file);
  return paths;
}

}  // namespace

const void* open_module(const std::string& name, const std::string& needed_for) {
  static std::mutex mutex;
  static std::map<std::string, const void*> opened;
  const std::lock_guard lock(mutex);
  if (const auto found = opened.find(name); found != opened.end()) return found->second;
  for (const fs::path& path : candidates(name)) {
    std::error_code error;
    if (!fs::exists(path, error)) continue;
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
      throw InputError(
          fmt::format("{} needs the module '{}', which cannot be loaded: {}", needed_for, name, dlerror()));
    using Entry = const void* (*)();
    const auto entry = reinterpret_cast<Entry>(dlsym(handle, "isocast_module"));
    if (!entry)
      throw InputError(
          fmt::format("{} needs the module '{}', but {} is not one", needed_for, name, path.string()));
    return opened[name] = entry();
  }
  throw InputError(fmt::format("{} needs the module '{}', which this build does not have", needed_for, name));
}

}  // namespace isocast
