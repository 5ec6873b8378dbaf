// Everything that the program does with the file of a volume before it draws it.
#pragma once

#include <filesystem>

namespace isocast::hostile {

/// Reads a volume, looks at all its samples, makes its surface and sends rays through it. Throws what these
/// throw.
void open_volume(const std::filesystem::path& path);

}  // namespace isocast::hostile
