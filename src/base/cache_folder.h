// Where the program keeps what it can make again.
#pragma once

#include <filesystem>

namespace isocast {

/// $XDG_CACHE_HOME/isocast/NAME, else ~/.cache/isocast/NAME; empty where neither is known. It need not exist.
[[nodiscard]] std::filesystem::path cache_folder(const char* name);

}  // namespace isocast
