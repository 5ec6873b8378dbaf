// OpenVDB files.
#pragma once

#include <isocast/base/mapped_file.h>
#include <isocast/volume/volume.h>

#include <filesystem>
#include <string>

namespace isocast {

/// Reads a grid of a .vdb file: float, double, int32 or int64, of the standard tree (5, 4, 3) and any class,
/// with a transform that keeps lines straight.
///
/// grid_name  empty: the first grid of such a type
/// half       floats saved as halves become floats (Volume::half_on_disk)
/// throws     InputError for every fault of the file; when no grid has this name, or a type that can be read
/// process    OpenVDB runs in a process of its own (isocast_openvdb), with as much memory and time as the
/// file's
///            size makes plausible: it trusts its files
[[nodiscard]] Volume read_vdb(const std::filesystem::path& path, const std::string& grid_name);

/// `bytes` bytes out of a row of blosc's blocks (each with its size in 8 bytes before it), a part of `file`;
/// in the same process. Throws InputError when the blocks are damaged or hold another number of bytes.
[[nodiscard]] MappedFile inflate_blosc(std::span<const std::byte> blocks, std::uint64_t bytes,
                                       const MappedFile& file, const std::filesystem::path& path);

}  // namespace isocast
