// The places of a grid's bricks.
#pragma once

#include <isocast/volume/bricks/brick_map.h>
#include <isocast/volume/bricks/bricks.h>

#include <vector>

namespace isocast {

/// Finds bricks by place in constant time.
class BrickDirectory {
 public:
  BrickDirectory() = default;
  /// grid     that of dense bricks
  /// samples  sparse: cells between these may be asked for
  BrickDirectory(const Bricks& bricks, const GridView& grid, const SampleBox& samples);

  /// False where there are no bricks, or sparse ones lie too far apart (more than 2^22 nodes between them).
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] BrickMap view() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  void add_nodes(const Bricks& bricks, const SampleBox& samples);

  BrickMap map_ = {};
  std::vector<std::uint32_t> nodes_, bricks_;
  bool complete_ = false;
};

}  // namespace isocast
