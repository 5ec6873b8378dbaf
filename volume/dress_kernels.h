// The table of what dressing does for many hits at once, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// A packet of a stream's hits on its way to position, normal and value; double precision.
///
/// mine      1 where the hit is to be dressed, else 0: such slots hold no meaning
/// world     position
/// place     in the cell, [0,1]
/// corners   of the cell, x fastest, in stored units
/// gradient  in grid space
struct alignas(64) HitsToDress {
  double mine[kPacketSize];
  double world[3][kPacketSize], place[3][kPacketSize];
  double corners[8][kPacketSize];
  double gradient[3][kPacketSize];
};

/// first: the packet's first slot in its stream.
///
/// locate         finds world and place; rows of grid_from_world: {A | b}
/// differentiate  the gradient of the trilinear interpolant, from place and corners
/// turn           unit normals in the world, turned against the ray, from the gradient; zero where it is
/// interpolate    slope times the interpolant plus intercept
struct DressKernels {
  void (*locate)(const double (&grid_from_world)[3][4], const RayStream& rays, const HitStream& hits,
                 int first, HitsToDress& dress);
  void (*differentiate)(HitsToDress& dress);
  void (*turn)(const double (&grid_from_world)[3][4], const RayStream& rays, int first,
               const HitsToDress& dress, double (&normal)[3][kStreamSize]);
  void (*interpolate)(double slope, double intercept, int first, const HitsToDress& dress,
                      double (&value)[kStreamSize]);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const DressKernels& dress_kernels(Isa isa);

}  // namespace isocast
