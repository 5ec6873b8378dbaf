// Where a tile's pixels are in its stream.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/ray/stream.h>

namespace isocast::inline ISO_ISA {

/// The slot of pixel (x, y) of a tile, 0 to 15 each, in View::fill's order: packet after packet of 4x4
/// pixels.
constexpr int tile_slot(int x, int y) { return (y / 4 * 4 + x / 4) * kPacketSize + y % 4 * 4 + x % 4; }

}  // namespace isocast::inline ISO_ISA
