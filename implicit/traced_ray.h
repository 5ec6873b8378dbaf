// Rays on their way through a formula's box, part by part.
#pragma once

#include <isocast/implicit/ray_beams.h>

namespace isocast {

/// begin    nothing is left to be found before it
/// sides    of each iso-value there, if `carried`
/// doubt    something before begin was not told
struct TracedRay {
  ClippedRay ray;
  double begin;
  std::uint32_t sides;
  bool active, carried, doubt;
  KnownCrossing known;
};

/// A part of a stream's rays as a solver has it.
template <class T> struct TracedPart {
  SegmentStream<T> segments;
  SegmentRoots<T> roots;
  ClippedRay pieces[kStreamSize];
};

}  // namespace isocast
