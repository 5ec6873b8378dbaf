#include <isocast/volume/bricks/brick_directory.h>
#include <isocast/volume/bricks/brick_mask.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr int kNodeShift = kBrickShift + 3;
constexpr std::int64_t kMostNodes = std::int64_t(1) << 22;

}  // namespace

BrickDirectory::BrickDirectory(const Bricks& bricks, const GridView& grid, const SampleBox& samples) {
  if (bricks.count == 0) return;
  complete_ = true;
  if (!bricks.first.empty()) add_nodes(bricks, samples);
  else
    for (int a = 0; a < 3; ++a) map_.dims[a] = grid.levels[0].dims[a];
}

void BrickDirectory::add_nodes(const Bricks& bricks, const SampleBox& samples) {
  std::array<std::int32_t, 3> lo, hi;
  for (int a = 0; a < 3; ++a) {
    lo[a] = samples.first[a];
    hi[a] = samples.last[a] - 1;
    for (const auto& first : bricks.first) {
      lo[a] = std::min(lo[a], first[a]);
      hi[a] = std::max(hi[a], first[a]);
    }
  }
  std::int64_t count = 1;
  for (int a = 0; a < 3; ++a) {
    map_.origin[a] = lo[a] >> kNodeShift << kNodeShift;
    map_.dims[a] = (hi[a] >> kNodeShift) - (lo[a] >> kNodeShift) + 1;
    count = std::min(count * map_.dims[a], kMostNodes + 1);
  }
  complete_ = count <= kMostNodes;
  if (!complete_) return;
  nodes_.assign(static_cast<std::size_t>(count), kNoBrick);
  for (std::size_t i = 0; i < bricks.count; ++i) {
    std::size_t node = 0, place = 0;
    for (int a = 2; a >= 0; --a) {
      const std::int32_t brick = (bricks.first[i][a] - map_.origin[a]) >> kBrickShift;
      node = node * static_cast<std::size_t>(map_.dims[a]) + static_cast<std::size_t>(brick >> 3);
      place = place * 8 + static_cast<std::size_t>(brick & 7);
    }
    if (nodes_[node] == kNoBrick) {
      nodes_[node] = static_cast<std::uint32_t>(bricks_.size());
      bricks_.resize(bricks_.size() + kNodeBricks, kNoBrick);
    }
    bricks_[nodes_[node] + place] = static_cast<std::uint32_t>(i);
  }
}

BrickMap BrickDirectory::view() const {
  BrickMap map = map_;
  map.nodes = nodes_.empty() ? nullptr : nodes_.data();
  map.bricks = bricks_.data();
  return map;
}

std::size_t BrickDirectory::bytes() const { return (nodes_.size() + bricks_.size()) * sizeof(std::uint32_t); }

}  // namespace isocast
