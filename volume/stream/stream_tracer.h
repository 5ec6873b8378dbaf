// Streams of rays in any order through the bricks of a grid: all march, then the cells they have found are
// solved.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/stream/kernels.h>

namespace isocast {

/// As trace_first_hits and trace_next_hits (query.h), with the same bits, for a grid whose bricks are known.
/// What is counted as blocks differs: they are those of the masks.
void trace_first_hits(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
                      HitStream& hits, TraceCounts& counts);
void trace_next_hits(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
                     HitStream& hits, TraceCounts& counts);

}  // namespace isocast
