// The sparse half of trace_first_hits and trace_next_hits.
#pragma once

#include <isocast/volume/query.h>

namespace isocast {

/// For a query whose samples are in a tree; `next`: behind the hits that `hits` holds.
void trace_sparse(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits,
                  TraceCounts& counts);

}  // namespace isocast
