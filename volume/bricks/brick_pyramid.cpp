#include <isocast/volume/bricks/brick_pyramid.h>
#include <isocast/volume/visit_grid.h>

#include <algorithm>

namespace isocast {
namespace {

std::size_t product(const std::int32_t (&n)[3]) {
  return std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]);
}

std::size_t index_of(const std::int32_t (&dims)[3], const std::int32_t (&at)[3]) {
  return (std::size_t(at[2]) * std::size_t(dims[1]) + std::size_t(at[1])) * std::size_t(dims[0]) +
         std::size_t(at[0]);
}

// Calls visit(at) for all places.
void each_place(const std::int32_t (&dims)[3], const auto& visit) {
  for (std::int32_t z = 0; z < dims[2]; ++z)
    for (std::int32_t y = 0; y < dims[1]; ++y)
      for (std::int32_t x = 0; x < dims[0]; ++x) visit({x, y, z});
}

// Calls visit(at) for all bricks that are there.
void each_brick(const BrickMap& map, const auto& visit) {
  if (!map.nodes) return each_place(map.dims, visit);
  each_place(map.dims, [&](const std::int32_t(&node)[3]) {
    if (map.nodes[index_of(map.dims, node)] == kNoBrick) return;
    each_place({8, 8, 8}, [&](const std::int32_t(&place)[3]) {
      const std::int32_t at[3] = {node[0] * 8 + place[0], node[1] * 8 + place[1], node[2] * 8 + place[2]};
      if (find_brick(map, at) != kNoBrick) visit(at);
    });
  });
}

}  // namespace

BrickPyramid::BrickPyramid(const BrickMap& map, const VolumeQuery& query) {
  add_bricks(map, query);
  while (product(levels_.back().dims) > 1) add_level(map);
}

void BrickPyramid::add_bricks(const BrickMap& map, const VolumeQuery& query) {
  Level& level = levels_.emplace_back();
  for (int a = 0; a < 3; ++a) level.dims[a] = map.nodes ? 2 * map.dims[a] : (map.dims[a] + 3) / 4;
  std::size_t cubes = product(level.dims);
  if (map.nodes)
    cubes = kNodeCubes * std::size_t(std::count_if(map.nodes, map.nodes + product(map.dims),
                                                   [](std::uint32_t node) { return node != kNoBrick; }));
  level.words.assign(cubes, 0);
  visit_grid(query, [&]<class Grid>(GridTag<Grid>) {
    const Grid grid(query);
    typename Grid::Place place;
    each_brick(map, [&](const std::int32_t(&at)[3]) {
      if (!map.nodes && !grid.block_active(0, at, place)) return;
      const std::int32_t cube[3] = {at[0] >> 2, at[1] >> 2, at[2] >> 2};
      level.words[map.nodes ? cube_in_node(map, cube) : index_of(level.dims, cube)] |= std::uint64_t(1)
                                                                                       << bit_in_cube(at);
    });
  });
}

// The next coarser one.
void BrickPyramid::add_level(const BrickMap& map) {
  const Level& below = levels_.back();
  const bool by_nodes = levels_.size() == 1 && map.nodes;
  Level level;
  for (int a = 0; a < 3; ++a) level.dims[a] = (below.dims[a] + 3) / 4;
  level.words.assign(product(level.dims), 0);
  each_place(below.dims, [&](const std::int32_t(&at)[3]) {
    if (by_nodes && map.nodes[index_of(map.dims, {at[0] >> 1, at[1] >> 1, at[2] >> 1})] == kNoBrick) return;
    if (below.words[by_nodes ? cube_in_node(map, at) : index_of(below.dims, at)] == 0) return;
    level.words[index_of(level.dims, {at[0] >> 2, at[1] >> 2, at[2] >> 2})] |= std::uint64_t(1)
                                                                               << bit_in_cube(at);
  });
  levels_.push_back(std::move(level));
}

PyramidView BrickPyramid::view() const {
  PyramidView view = {};
  view.levels = int(levels_.size());
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    view.words[l] = levels_[l].words.data();
    std::ranges::copy(levels_[l].dims, view.dims[l]);
  }
  return view;
}

std::size_t BrickPyramid::bytes() const {
  std::size_t bytes = 0;
  for (const Level& level : levels_) bytes += level.words.size() * sizeof(level.words[0]);
  return bytes;
}

}  // namespace isocast
