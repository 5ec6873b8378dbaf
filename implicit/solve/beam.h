// Beams, each around the rays of a packet or of a tile: the plain data that formula kernels narrow.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

inline constexpr int kMostBeams = 16;

/// The points e + k d + u (eu + k du) + v (ev + k dv), 0 <= k <= 1, beam by beam: a ray for each u and v of
/// [-1, 1], of which every true point lies within slack + k spread, axis by axis.
///
/// from, to     what of k may hold a root of any ray; from > to: there is none
/// run_to       the end of the slabs in a row, from the first on, that are not proved empty
/// crosses      every ray has one crossing of iso-value `iso` from there on, before any other, and none
/// before
///              it, at k = at + u along_u + v along_v within `radius`; `rises`: f goes up
/// slabs        parts of each beam that are looked at; count times slabs is at most 64
/// evaluations  of the tape, over slabs of beams
template <class T> struct alignas(64) BeamStream {
  T e[3][kMostBeams], d[3][kMostBeams], eu[3][kMostBeams], du[3][kMostBeams], ev[3][kMostBeams],
      dv[3][kMostBeams], slack[3][kMostBeams], spread[3][kMostBeams];
  T from[kMostBeams], to[kMostBeams], run_to[kMostBeams];
  T at[kMostBeams], along_u[kMostBeams], along_v[kMostBeams], radius[kMostBeams];
  std::uint8_t iso[kMostBeams];
  bool crosses[kMostBeams], rises[kMostBeams];
  int count, slabs;
  std::int64_t evaluations;
};

}  // namespace isocast
