// Samples from where a file keeps them into a volume: mapped in place, copied or inflated.
#pragma once

#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/volume/io/inflate.h>
#include <isocast/volume/volume.h>

#include <filesystem>

namespace isocast {

/// Bytes that the samples of `volume` (its dims and type) take. Throws InputError when a dimension is below 1
/// or above kMaxDim, or the product has no 64-bit size.
[[nodiscard]] std::uint64_t checked_bytes(const Volume& volume, const std::filesystem::path& path);

/// Gives the volume a buffer for its samples and returns it; pages cost nothing until they are written.
/// Throws InputError when this machine has less memory. Call it only with sizes that the file's own size
/// makes plausible (check_ratio).
[[nodiscard]] std::byte* allocate_samples(Volume& volume, const std::filesystem::path& path);

/// Throws InputError unless `bytes` may come out of so many compressed ones: they are at most 200 MB, or at
/// most 200 times as much. A small file that claims more would take this machine's memory.
void check_ratio(std::uint64_t bytes, std::uint64_t compressed, const std::filesystem::path& path);

/// Samples that lie uncompressed from `offset` on: mapped in place if in native order and aligned for their
/// type, else copied. Throws InputError when the file ends before; what follows them is ignored.
void place_samples(Volume& volume, const MappedFile& file, std::uint64_t offset, bool big_endian,
                   const std::filesystem::path& path);

/// The same for samples that are the last bytes of the file, none of them before `offset`.
void place_last_samples(Volume& volume, const MappedFile& file, std::uint64_t offset, bool big_endian,
                        const std::filesystem::path& path);

/// Bytes that are kept of so many compressed ones, before a look ahead has found all of those that should
/// follow: a broken stream then takes less memory than twice its file and 256 MB.
[[nodiscard]] std::uint64_t kept_unseen(std::uint64_t compressed);

/// The next bytes of a compressed stream; the number filled, which is below that of `out` where it ends.
[[nodiscard]] std::uint64_t inflate_into(std::span<std::byte> out, Inflater& inflater);

/// Samples of a compressed stream, behind `skip` of its bytes. Throws InputError when it is damaged, ends
/// before, or is too small to hold them (check_ratio).
void inflate_samples(Volume& volume, Inflater& inflater, std::uint64_t skip, bool big_endian,
                     const std::filesystem::path& path);

/// The error of a file that holds fewer bytes of samples than it should.
[[nodiscard]] InputError missing_samples(const Volume& volume, std::uint64_t found,
                                         const std::filesystem::path& path);

}  // namespace isocast
