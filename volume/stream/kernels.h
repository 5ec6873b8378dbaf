// The table of what streams of rays in any order need, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// enter   the rays of the stream that enter the grid within [t_min, t_max], queued (enter.h)
/// resume  puts the queued rays of a stream into cells that they are known to cross
/// march   from cell to cell until each queued ray has found an active one or is at its end (march_lanes.h)
/// chords  of up to 16 rays in their cells (chords.h)
struct StreamKernels {
  void (*enter)(const MarchField& field, const RayStream& rays, const double (&t_max)[kStreamSize],
                WalkingRays& to);
  void (*resume)(const RayStream& rays, const std::int32_t (&cells)[3][kStreamSize], WalkingRays& to);
  void (*march)(const MarchField& field, WalkingRays& rays, TraceCounts& counts);
  void (*chords)(const WalkingRays& rays, const std::uint16_t* slots, int count, CellChords& chords);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const StreamKernels& stream_kernels(Isa isa);

}  // namespace isocast
