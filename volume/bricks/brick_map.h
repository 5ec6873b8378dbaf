// Which brick a cell lies in, as kernels see it.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast {

/// The bricks of a grid by their places. A node is a cube of 8^3 bricks.
///
/// origin  the first cell, a multiple of a brick's edge (dense) or of a node's (sparse)
/// dims    dense: bricks per axis, of which all are there, numbered with x fastest; sparse: nodes per axis
/// nodes   sparse: where in `bricks` the 512 of each node start, or kNoBrick; null: dense
/// bricks  sparse: their numbers, or kNoBrick
struct BrickMap {
  std::int32_t origin[3], dims[3];
  const std::uint32_t* nodes;
  const std::uint32_t* bricks;
};
inline constexpr std::uint32_t kNoBrick = 0xffffffffu;
inline constexpr int kNodeBricks = 512;

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// The number of a brick by its place: bricks from the map's origin on, per axis. kNoBrick where there is
/// none; `node`: nor any in its whole node.
struct FoundBrick {
  std::size_t number;
  bool node = false;
};
ISO_HD inline FoundBrick find_brick(const BrickMap& map, const std::int32_t (&at)[3]) {
  const auto number = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return (std::size_t(z) * std::size_t(map.dims[1]) + std::size_t(y)) * std::size_t(map.dims[0]) +
           std::size_t(x);
  };
  if (!map.nodes) return {number(at[0], at[1], at[2])};
  const std::uint32_t node = map.nodes[number(at[0] >> 3, at[1] >> 3, at[2] >> 3)];
  if (node == kNoBrick) return {kNoBrick, true};
  return {map.bricks[node + std::uint32_t((at[2] & 7) * 64 + (at[1] & 7) * 8 + (at[0] & 7))]};
}

}  // namespace isocast::inline ISO_ISA
