#include <dlfcn.h>
#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/module.h>
#include <link.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

namespace isocast {
namespace fs = std::filesystem;

namespace {

// The folders in which the loader looks on behalf of this code. The run path is among them, to which the
// package of an installation adds its modules for the programs that use it. (dlopen of a bare name would look
// there too, but AddressSanitizer hides its caller.)
std::vector<fs::path> loader_folders() {
  Dl_info own;
  void* handle = nullptr;
  Dl_serinfo size;
  if (!dladdr1(reinterpret_cast<void*>(&loader_folders), &own, &handle, RTLD_DL_LINKMAP) ||
      dlinfo(handle, RTLD_DI_SERINFOSIZE, &size) != 0)
    return {};
  std::vector<Dl_serinfo> buffer(1 + size.dls_size / sizeof size, size);
  if (dlinfo(handle, RTLD_DI_SERINFO, buffer.data()) != 0) return {};
  const Dl_serpath* folders = buffer.front().dls_serpath;
  std::vector<fs::path> paths;
  for (unsigned i = 0; i < size.dls_cnt; ++i) paths.emplace_back(folders[i].dls_name);
  return paths;
}

// Beside the executable (build tree and installation alike), then where the loader looks for a program that
// uses the installed library, then where the library was to be installed.
std::vector<fs::path> candidates(const std::string& file) {
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  std::vector<fs::path> paths;
  if (!error) paths.push_back(executable.parent_path().parent_path() / ISOCAST_LIBDIR / "isocast" / file);
  for (const fs::path& folder : loader_folders()) paths.push_back(folder / file);
  paths.push_back(fs::path(ISOCAST_INSTALL_MODULE_DIR) / file);
  return paths;
}

}  // namespace

fs::path find_part(const std::string& file) {
  std::error_code error;
  for (const fs::path& path : candidates(file))
    if (fs::exists(path, error)) return path;
  return {};
}

const void* open_module(const std::string& name, const std::string& needed_for) {
  static std::mutex mutex;
  static std::map<std::string, const void*> opened;
  const std::lock_guard lock(mutex);
  if (const auto found = opened.find(name); found != opened.end()) return found->second;
  if (const fs::path path = find_part("isocast_" + name + ".so"); !path.empty()) {
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
