// Samples and nothing else: dimensions and type come from the command line or from the file's name.
#pragma once

#include <isocast/volume/io/read_volume.h>

namespace isocast {

/// Reads a .raw file; what `options` leave open is taken from a name like bonsai_256x256x256_uint8.raw.
[[nodiscard]] Volume read_raw(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace isocast
