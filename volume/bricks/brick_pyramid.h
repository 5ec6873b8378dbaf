// Which bricks may hold active cells, as bits of cubes, of cubes of cubes and so on.
#pragma once

#include <isocast/volume/bricks/brick_map.h>
#include <isocast/volume/query.h>

#include <cstddef>
#include <vector>

namespace isocast {

/// Bits in the order of brick_mask.h. Places are those of the map.
class BrickPyramid {
 public:
  BrickPyramid() = default;
  /// Dense: the bricks whose ranges hold an iso-value of the query. Sparse: all that are there.
  BrickPyramid(const BrickMap& map, const VolumeQuery& query);

  [[nodiscard]] PyramidView view() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Level {
    std::vector<std::uint64_t> words;
    std::int32_t dims[3];
  };
  void add_bricks(const BrickMap& map, const VolumeQuery& query);
  void add_level(const BrickMap& map);

  std::vector<Level> levels_;
};

}  // namespace isocast
