// Fields to sparse volume files: OpenVDB and NanoVDB.
#pragma once

#include <isocast/data_gen/write.h>
#include <isocast/volume/sparse_tree.h>

namespace isocast {

/// type        of .vdb: f32 f64 i32 i64; of .nvdb also i16 and codes (fp4 fp8 fp16 fpn); whole numbers are
/// rounded band        a narrow band: samples with |v| <= band are active, the others +-band; the background
/// is band. NaN: every
///             sample is active
/// background  of a grid without a band
/// name        of the grid; empty: that of the file without its extension
struct SparseWriteOptions {
  SparseType type = SparseType::f32;
  double band = std::numeric_limits<double>::quiet_NaN(), background = 0;
  std::string name;
};

/// Whether a name ends in .vdb or .nvdb.
[[nodiscard]] bool is_sparse_file(const std::filesystem::path& target);

/// "f32" ... "fpn"; throws InputError for other words and for types that the target's format does not have.
[[nodiscard]] SparseType sparse_type_for(const std::filesystem::path& target, const std::string& word);

/// Samples `field` and writes it; sample (0, 0, 0) of the grid is grid point (0, 0, 0) of the file.
///
/// memory  64 MB of samples at a time, and the whole tree in the process that writes it
/// throws  InputError for a bad grid or band, or when the file cannot be written; what was there before stays
/// until the
///         new file is complete
WriteReport write_sparse_field(const Field& field, const SampleGrid& grid,
                               const std::filesystem::path& target, const SparseWriteOptions& options);

}  // namespace isocast
