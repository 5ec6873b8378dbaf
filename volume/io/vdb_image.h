// What passes between this program and the process that knows OpenVDB.
#pragma once

#include <isocast/volume/sparse_tree.h>

#include <array>
#include <cstdint>

namespace isocast {

/// A grid in a memory file. It holds, one after the other: `leaf_count` leaves of leaf_bytes(type, 0) bytes
/// of samples and 64 of mask; their origins (VdbOrigin), padded to a multiple of 8 bytes; `tile_count`
/// TileBlock; `text_bytes` of text: the grid's name, its class and the names of the other grids, each ended
/// by a zero; and this, at the very end.
struct VdbImage {
  std::uint64_t leaf_count, tile_count, text_bytes;
  std::uint64_t background;  // as in SparseTile
  double world_from_grid[3][4];
  SparseType type;
  bool half_on_disk;
};
using VdbOrigin = std::array<std::int32_t, 3>;

/// A grid to be written, sent as: this, then leaves and tiles, each a VdbPart and, of a leaf, its samples and
/// mask as above; then a VdbPart of kind `end`.
///
/// type   the samples': f32 f64 i16 i32 i64 for codes too
/// codes  the type in the file
struct VdbOrder {
  SparseType type, codes;
  std::uint8_t nanovdb, level_set;
  std::uint64_t background;
  double world_from_grid[3][4];
  char name[64];
};
enum class VdbPartKind : std::uint32_t { leaf, tile, end };
struct VdbPart {
  VdbPartKind kind;
  TileBlock block;  // of a leaf, its origin alone
};

}  // namespace isocast
