// The table of what streams of rays in any order need, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// enter   the rays of the stream that enter the grid within [t_min, t_max], queued (enter.h); cells: that
/// they
///         are known to be in, or null
/// march   from active cell to active cell until each queued ray has met its root, which the solver tells, or
///         is at its end (march_rays.h)
/// chords  of the rays in the first cells of a queue, up to 16 (chords.h)
struct StreamKernels {
  void (*enter)(const MarchField& field, const RayStream& rays, const double (&t_max)[kStreamSize],
                const std::int32_t (*cells)[kStreamSize], WalkingRays& to);
  void (*march)(const MarchField& field, WalkingRays& rays, CellSolver& solver, TraceCounts& counts);
  void (*chords_float)(const WalkingRays& rays, const CellQueue& queue, int count, CellChords<float>& chords);
  void (*chords_double)(const WalkingRays& rays, const CellQueue& queue, int count,
                        CellChords<double>& chords);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const StreamKernels& stream_kernels(Isa isa);

}  // namespace isocast
