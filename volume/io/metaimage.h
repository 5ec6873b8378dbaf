// MetaImage volumes (MetaIO, ITK): .mha with its samples, .mhd with a data file beside it.
#pragma once

#include <isocast/volume/volume.h>

#include <filesystem>

namespace isocast {

/// Reads binary scalars of 3 dimensions, or 4 of which the last is 1, plain or as one zlib stream; one data
/// file.
///
/// world   Offset is the centre of sample 0; row i of TransformMatrix, times the spacing of axis i, leads to
///         the next sample along axis i, as in ITK
/// values  ElementToIntensityFunctionSlope and ...Offset; a byte order that is not told is little
[[nodiscard]] Volume read_metaimage(const std::filesystem::path& path);

}  // namespace isocast
