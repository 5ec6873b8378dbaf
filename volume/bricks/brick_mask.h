// The active cells of a brick as bits.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

/// The cells of a brick of 16^3 whose corners enclose an iso-value. Block b of 4^3 cells is number x + 4 y +
/// 16 z of 64, and so is a cell in its block.
///
/// blocks  bit b set: cells[b] is not 0
struct BrickMask {
  std::uint64_t blocks;
  std::uint64_t cells[64];
};
inline constexpr int kBrickShift = 4, kBrickSize = 1 << kBrickShift;

}  // namespace isocast
