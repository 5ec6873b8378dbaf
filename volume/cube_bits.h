// The boxes of a cube of 4^3 as bits.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast::inline ISO_ISA {

/// Blocks in a brick or cells in a block: a cube of 4^3.
inline constexpr int kCubeBoxes = 64;

/// Where a box of a cube begins along an axis, in boxes.
template <class V> inline V place_in_cube(V number, int axis) { return number >> 2 * axis & 3; }

/// Bits in the order of their numbers exclusive-ored with `flip`: x, y and z are either reversed or not.
inline std::uint64_t flipped(std::uint64_t bits, int flip) {
  const auto swap = [&](std::uint64_t low, int by) { bits = (bits >> by & low) | (bits & low) << by; };
  if (flip & 1) {
    swap(0x5555555555555555u, 1);
    swap(0x3333333333333333u, 2);
  }
  if (flip & 4) {
    swap(0x0f0f0f0f0f0f0f0fu, 4);
    swap(0x00ff00ff00ff00ffu, 8);
  }
  if (flip & 16) {
    swap(0x0000ffff0000ffffu, 16);
    swap(0x00000000ffffffffu, 32);
  }
  return bits;
}

}  // namespace isocast::inline ISO_ISA
