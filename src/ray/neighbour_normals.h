// Normals from the hits of neighbouring pixels.
#pragma once

#include <isocast/ray/surface.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// find_neighbour_normals  for the hits of one object by a primary stream (View::fill's order): the normal of
///                         the triangle with those of the left or right and of the upper or lower neighbour
///                         in the tile that are nearest in depth, turned against the ray. made[i] tells where
///                         there are such; nothing else is written. Returns how many
///                         hits have none
///
/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008
struct NormalKernels {
  int (*find_neighbour_normals)(const RayStream& rays, const HitStream& hits, std::uint16_t object,
                                DressedHits& dressed, bool (&made)[kStreamSize]);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const NormalKernels& normal_kernels(Isa isa);

}  // namespace isocast
