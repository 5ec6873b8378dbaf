// Any volume file to a Volume.
#pragma once

#include <isocast/volume/volume.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace isocast {

/// What a .raw file does not say itself; what is left open comes from its name
/// (bonsai_256x256x256_uint8.raw). `skip` counts the bytes before the samples. `grid`: which one of a .vdb or
/// .nvdb file; empty: the first that can be read.
struct ReadOptions {
  std::optional<std::array<std::int64_t, 3>> dims;
  std::optional<SampleType> type;
  bool big_endian = false;
  std::uint64_t skip = 0;
  std::string grid = {};
  bool operator==(const ReadOptions&) const = default;

  /// Whether anything is set that only .raw files need.
  [[nodiscard]] bool describes_raw() const { return dims || type || big_endian || skip; }
};

/// Whether a name ends like that of a format below; capitals count alike.
[[nodiscard]] bool has_volume_extension(const std::filesystem::path& path);

/// Reads a volume; the extension chooses the format: .raw .nrrd .nhdr .mhd .mha .nii .nii.gz
/// .vti.
///
/// samples  stay in the type of the file; mapped in place when uncompressed, aligned and in native byte order
/// world    the file's own space, units and handedness: a grid point is the centre of a sample
/// throws   InputError for any other extension, options that the format does not take, and every fault of the
///          file; memory is taken only for sizes that the file's own size makes plausible
[[nodiscard]] Volume read_volume(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace isocast
