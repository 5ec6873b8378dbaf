// Environments from pictures on disk.
#pragma once

#include <isocast/scene/environment.h>

#include <filesystem>
#include <memory>

namespace isocast {

/// Reads a picture of all directions (channels R G B, or where they are missing the first as grey; see
/// read_image). NaN counts as 0, infinities as the largest half float. Throws InputError.
[[nodiscard]] std::shared_ptr<const Environment> read_environment(const std::filesystem::path& path);

}  // namespace isocast
