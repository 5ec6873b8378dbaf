#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/bricks/bricks.h>

#include <algorithm>

namespace isocast {
namespace {

using Point = std::array<std::int32_t, 3>;
constexpr std::size_t kMostBricks = std::size_t(1) << 24;

// The bricks of the cells with a corner in a block of samples; of a tile only those that reach over its
// border. False where there would be too many.
bool add_block(const Point& origin, std::int32_t edge, bool tile, std::vector<Point>& bricks) {
  Point lo, hi;
  for (int a = 0; a < 3; ++a) {
    lo[a] = (origin[a] - 1) >> kBrickShift;
    hi[a] = (origin[a] + edge - 1) >> kBrickShift;
  }
  for (std::int32_t z = lo[2]; z <= hi[2]; ++z)
    for (std::int32_t y = lo[1]; y <= hi[1]; ++y) {
      const bool border = !tile || z == lo[2] || z == hi[2] || y == lo[1] || y == hi[1];
      const std::int32_t step = border ? 1 : std::max(hi[0] - lo[0], 1);
      for (std::int32_t x = lo[0]; x <= hi[0]; x += step) {
        if (bricks.size() == kMostBricks) return false;
        bricks.push_back({x * kBrickSize, y * kBrickSize, z * kBrickSize});
      }
    }
  return true;
}

void make_unique(std::vector<Point>& bricks) {
  std::ranges::sort(bricks);
  bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
}

}  // namespace

Bricks dense_bricks(const GridView& grid) {
  const std::int32_t(&n)[3] = grid.levels[0].dims;
  return {std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]), {}};
}

Bricks sparse_bricks(const SparseTree& tree) {
  std::vector<Point> bricks;
  bool complete = true;
  for (const SparseLeaf& leaf : tree.leaves())
    complete = complete && add_block({leaf.origin[0], leaf.origin[1], leaf.origin[2]}, 8, false, bricks);
  for (const TileBlock& tile : tree.active_tiles())
    complete = complete && add_block(tile.origin, 1 << tile.edge, true, bricks);
  if (!complete) return {};
  make_unique(bricks);
  return {bricks.size(), std::move(bricks)};
}

}  // namespace isocast
