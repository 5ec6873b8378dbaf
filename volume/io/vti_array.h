// The samples of one VTK data array, in any of its encodings.
#pragma once

#include <isocast/base/mapped_file.h>
#include <isocast/volume/volume.h>

#include <filesystem>
#include <string_view>

namespace isocast {

enum class VtiEncoding { ascii, base64, raw };

/// text        where the array begins, to the end of its element or of the appended data; raw: inside `file`
/// wide_words  the words before the samples (sizes and counts) have 64 bits, else 32
/// compressed  in zlib blocks
struct VtiArray {
  std::string_view text;
  VtiEncoding encoding = VtiEncoding::raw;
  bool wide_words = false, compressed = false, big_endian = false;
};

/// Reads the samples of `volume` (its dims and type). Throws InputError when the array holds fewer or is
/// damaged.
void read_vti_array(Volume& volume, const VtiArray& array, const MappedFile& file,
                    const std::filesystem::path& path);

}  // namespace isocast
