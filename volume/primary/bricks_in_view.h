// The bricks of a grid that a camera may see, nearest first, patch by patch.
#pragma once

#include <isocast/render/camera.h>
#include <isocast/volume/bricks/bricks.h>
#include <isocast/volume/primary/patch.h>
#include <isocast/volume/primary/screen_map.h>
#include <isocast/volume/query.h>

#include <optional>
#include <vector>

namespace isocast {

/// index    among the bricks of the grid
/// first    its first cell
/// pixels   of the picture, in which all its rays lie, wherever in their pixels they are
/// nearest  no ray meets the brick before this t
struct SeenBrick {
  std::size_t index;
  std::int32_t first[3];
  PixelBox pixels;
  double nearest;
};

/// patches  for each patch of the picture, row by row: which of the bricks may be seen there
struct BricksInView {
  ScreenMap map;
  std::vector<SeenBrick> bricks;
  int columns, rows;
  std::vector<std::vector<std::uint32_t>> patches;
};

/// Bricks whose samples may enclose some iso-value. Nothing where the camera and the grid are so far from
/// each other, or of so different sizes, that only the walk is sure of its planes, and where it is faster:
/// where bricks are many and pixels few.
[[nodiscard]] std::optional<BricksInView> find_bricks(const VolumeQuery& query, const Bricks& bricks,
                                                      const Transform& world_from_grid, const View& view);

}  // namespace isocast
