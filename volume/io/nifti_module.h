// The table of the module `nifti`, the only part that needs libnifti.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace isocast {

/// Size of the larger header, that of NIfTI-2.
inline constexpr std::size_t kNiftiHeaderBytes = 540;

/// What a header says. Missing dims are 1; type is libnifti's word ("UINT8"); problem: why the header cannot
/// be used, and then nothing else is set.
struct NiftiHeader {
  std::string problem;
  std::int64_t dims[3] = {1, 1, 1};
  std::string type;
  bool big_endian = false;
  std::uint64_t offset = 0;  // of the samples
  double world_from_grid[3][4] = {};
  double slope = 1, intercept = 0;
};

struct NiftiModule {
  /// Interprets the first bytes of a file, in either byte order.
  NiftiHeader (*interpret)(std::span<const std::byte> bytes);
};

}  // namespace isocast
