// A volume as it was read: samples in the type of the file, where they lie in the world, how they are scaled.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/volume/sample_type.h>
#include <isocast/volume/sparse_tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// A dense grid of samples, or a sparse one: then `tree` holds the samples, grid space is its index space,
/// and dims counts the grid points between the first and the last active one (0 0 0 when none is).
///
/// Dense: dims[0] varies fastest: sample (i, j, k) is element i + dims[0] * (j + dims[1] * k), in native byte
/// order. Grid space has samples at the integers; world_from_grid maps it to the world (spacing, origin and
/// axes in one, possibly left-handed). Users see values v = slope * stored + intercept. `storage` keeps the
/// samples alive (a mapping or a buffer).
struct Volume {
  SampleType type = SampleType::u8;
  std::array<std::int64_t, 3> dims = {0, 0, 0};
  const std::byte* samples = nullptr;
  std::shared_ptr<const void> storage;
  std::shared_ptr<const SparseTree> tree;
  Transform world_from_grid;
  double slope = 1, intercept = 0;
  std::string format;   // "raw", "nrrd", "nifti", "vti", "metaimage", "vdb", "nanovdb"
  bool mapped = false;  // the samples are pages of the file, not a copy

  // what files of sparse grids say of themselves; empty or false elsewhere
  std::string grid_name, grid_class;
  std::vector<std::string> other_grids;
  bool half_on_disk = false;

  [[nodiscard]] std::int64_t count() const { return dims[0] * dims[1] * dims[2]; }
  [[nodiscard]] std::int64_t bytes() const {
    return tree ? static_cast<std::int64_t>(tree->bytes())
                : count() * static_cast<std::int64_t>(size_of(type));
  }
  [[nodiscard]] std::string_view type_name() const { return tree ? name_of(tree->type()) : name_of(type); }
};

}  // namespace isocast
