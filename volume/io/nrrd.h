// NRRD volumes (teem): attached .nrrd and detached .nhdr.
#pragma once

#include <isocast/volume/volume.h>

#include <filesystem>

namespace isocast {

/// Reads scalar volumes of 3 axes, or 4 of which the first or last has size 1; encodings raw and gzip, one
/// data file. World: space directions and space origin (the centre of sample 0); without directions, spacings
/// (1 where not given) and axis mins (0 where not given), half a sample further in on axes with centering
/// "cell".
[[nodiscard]] Volume read_nrrd(const std::filesystem::path& path);

}  // namespace isocast
