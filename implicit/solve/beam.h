// Beams, each around the rays of a packet or of a tile: the plain data that formula kernels narrow.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

inline constexpr int kMostBeams = 16;

/// The points e + k d, 0 <= k <= 1, beam by beam; at k every true point of its rays lies within
/// slack + k spread of it, axis by axis.
///
/// from, to     what of k may hold a root; from > to: there is none
/// count        1, or up to kMostBeams
/// evaluations  of the tape, over slabs of beams
template <class T> struct alignas(64) BeamStream {
  T e[3][kMostBeams], d[3][kMostBeams], slack[3][kMostBeams], spread[3][kMostBeams];
  T from[kMostBeams], to[kMostBeams];
  int count;
  std::int64_t evaluations;
};

}  // namespace isocast
