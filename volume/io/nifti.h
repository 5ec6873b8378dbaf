// NIfTI-1 and NIfTI-2 in one file, plain or in gzip.
#pragma once

#include <isocast/volume/volume.h>

#include <filesystem>

namespace isocast {

/// Reads a .nii or .nii.gz of up to three dimensions (further ones of size 1). World: the sform, else the
/// qform, else the spacings. Values: scl_slope and scl_inter, a slope of 0 meaning none.
[[nodiscard]] Volume read_nifti(const std::filesystem::path& path);

}  // namespace isocast
