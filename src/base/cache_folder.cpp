#include <isocast/base/cache_folder.h>

#include <cstdlib>

namespace isocast {

std::filesystem::path cache_folder(const char* name) {
  const auto variable = [](const char* key) {
    const char* const value = std::getenv(key);
    return value ? std::filesystem::path(value) : std::filesystem::path();
  };
  if (const auto cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "isocast" / name;
  if (const auto home = variable("HOME"); !home.empty()) return home / ".cache" / "isocast" / name;
  return {};
}

}  // namespace isocast
