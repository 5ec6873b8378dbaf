// VTK image data in XML.
#pragma once

#include <isocast/volume/volume.h>

#include <filesystem>

namespace isocast {

/// Reads the active scalars of a .vti's point data, or its first array of one component; one piece; formats
/// ascii, binary (base64) and appended (raw or base64), plain or in zlib blocks. World: Origin + Direction *
/// (Spacing * index), where the index counts from the piece's extent on.
[[nodiscard]] Volume read_vti(const std::filesystem::path& path);

}  // namespace isocast
