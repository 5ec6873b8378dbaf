// NanoVDB files.
#pragma once

#include <isocast/volume/volume.h>

#include <filesystem>
#include <string>

namespace isocast {

/// Reads a grid of a .nvdb file: Float, Double, Int16, Int32, Int64, Fp4, Fp8, Fp16 or FpN of any class.
///
/// grid_name  empty: the first grid of such a type
/// samples    leaves stay where they are in the file, mapped if it is not compressed; the nodes above are
/// indexed
///            anew (SparseTree) after every offset was checked
/// throws     InputError for every fault of the file; when no grid has this name, or a type that can be read
[[nodiscard]] Volume read_nanovdb(const std::filesystem::path& path, const std::string& grid_name);

}  // namespace isocast
