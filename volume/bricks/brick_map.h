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
inline constexpr int kNodeBricks = 512, kNodeCubes = 8;

/// Which bricks may hold active cells (brick_pyramid.h).
///
/// words  of level l: a bit for each part of the cubes of 4^(l+1) bricks along an edge; of level 0 of a
/// sparse
///        map those of its nodes (cube_in_node)
/// dims   cubes per axis; one on the last level
struct PyramidView {
  static constexpr int kMaxLevels = 14;  // 2^30 cells
  const std::uint64_t* words[kMaxLevels];
  std::int32_t dims[kMaxLevels][3];
  int levels;
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// The number of a brick by its place: bricks from the map's origin on, per axis. kNoBrick where there is
/// none.
ISO_HD inline std::size_t find_brick(const BrickMap& map, const std::int32_t (&at)[3]) {
  const auto number = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return (std::size_t(z) * std::size_t(map.dims[1]) + std::size_t(y)) * std::size_t(map.dims[0]) +
           std::size_t(x);
  };
  if (!map.nodes) return number(at[0], at[1], at[2]);
  const std::uint32_t node = map.nodes[number(at[0] >> 3, at[1] >> 3, at[2] >> 3)];
  if (node == kNoBrick) return kNoBrick;
  return map.bricks[node + std::uint32_t((at[2] & 7) * 64 + (at[1] & 7) * 8 + (at[0] & 7))];
}

/// The bit of a part of a cube of 4^3, by its place or one in its own cube.
ISO_HD inline int bit_in_cube(const std::int32_t (&at)[3]) {
  return (at[0] & 3) + 4 * (at[1] & 3) + 16 * (at[2] & 3);
}

/// The number of a cube of 4^3 bricks in a node that is there, by its place: cubes from the map's origin on.
ISO_HD inline std::size_t cube_in_node(const BrickMap& map, const std::int32_t (&at)[3]) {
  const std::size_t node = (std::size_t(at[2] >> 1) * std::size_t(map.dims[1]) + std::size_t(at[1] >> 1)) *
                               std::size_t(map.dims[0]) +
                           std::size_t(at[0] >> 1);
  return map.nodes[node] / kNodeBricks * kNodeCubes +
         std::size_t((at[2] & 1) * 4 + (at[1] & 1) * 2 + (at[0] & 1));
}

/// The bits of the cube at a place of level l.
ISO_HD inline std::uint64_t cube_bits(const BrickMap& map, const PyramidView& pyramid, int l,
                                      const std::int32_t (&at)[3]) {
  if (l == 0 && map.nodes) return pyramid.words[0][cube_in_node(map, at)];
  const std::int32_t(&dims)[3] = pyramid.dims[l];
  return pyramid
      .words[l][(std::size_t(at[2]) * std::size_t(dims[1]) + std::size_t(at[1])) * std::size_t(dims[0]) +
                std::size_t(at[0])];
}

}  // namespace isocast::inline ISO_ISA
