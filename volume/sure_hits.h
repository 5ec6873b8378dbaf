// Rays that are blocked for sure, known without looking for where.
#pragma once

#include <isocast/volume/query.h>

namespace isocast {

/// Sets `hit` of rays that cross the surface of a dense grid of finite samples: on some of the places that
/// are looked at along them, a block of 4^3 cells lies on one side of an iso-value, and another, or where the
/// ray starts, on the other; f is continuous between them. Nothing is known of the other rays.
///
/// Few of a stream's rays are tried where hardly any is found to be blocked. Returns how many were found.
int find_sure_hits(const VolumeQuery& query, const RayStream& rays, bool (&hit)[kStreamSize],
                   TraceCounts& counts);

}  // namespace isocast
