// The table of what dressing does for many hits at once, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// Hits of a stream on their way to position, normal and value, slot by slot; double precision.
///
/// mine      1 where the hit is to be dressed, else 0: such slots hold no meaning
/// world     position
/// place     in the cell, [0,1]
/// corners   of the cell, x fastest, in stored units
/// gradient  in grid space
struct alignas(64) HitsToDress {
  double mine[kStreamSize];
  double world[3][kStreamSize], place[3][kStreamSize];
  double corners[8][kStreamSize];
  double gradient[3][kStreamSize];
};

/// locate         finds world and place; rows of grid_from_world: {A | b}
/// differentiate  the gradient of the trilinear interpolant, from place and corners
/// turn           unit normals in the world, turned against the ray, from the gradient; zero where it is
/// interpolate    slope times the interpolant plus intercept
struct DressKernels {
  void (*locate)(const double (&grid_from_world)[3][4], const RayStream& rays, const HitStream& hits,
                 HitsToDress& dress);
  void (*differentiate)(int size, HitsToDress& dress);
  void (*turn)(const double (&grid_from_world)[3][4], const RayStream& rays, const HitsToDress& dress,
               double (&normal)[3][kStreamSize]);
  void (*interpolate)(double slope, double intercept, int size, const HitsToDress& dress,
                      double (&value)[kStreamSize]);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const DressKernels& dress_kernels(Isa isa);

}  // namespace isocast
