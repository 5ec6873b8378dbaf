// Rays through all objects of a frame, one or many.
#pragma once

#include <isocast/render/frame.h>

namespace isocast {

/// The first hits of rays of any kind, nearer than those that `hits` holds.
void find_first_hits(const Frame& frame, const RayStream& rays, HitStream& hits, TraceCounts& counts);

/// True where anything is hit.
void find_any_hits(const Frame& frame, const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts);

/// The numbers of all objects that the rays may meet; in `list` where these are not all.
[[nodiscard]] std::span<const std::uint16_t> objects_for(const Frame& frame, const RayStream& rays,
                                                         std::vector<std::uint16_t>& list);

/// Position, normal and value of the hits, as wished.
void dress_all(const Frame& frame, const DressWishes& wishes, const RayStream& rays, const HitStream& hits,
               DressedHits& dressed);

}  // namespace isocast
