// Rays that no view orders, each with a polynomial of its own from values along it.
#pragma once

#include <isocast/implicit/frustum/block_query.h>

namespace isocast {

/// table      of the degree of the rays' polynomials: Chebyshev's points and the way to coefficients
/// exact      f has that degree at most, so that the table's factor bounds the polynomial's error between the
///            points; without it nothing is proved
/// slack      relative: what a coordinate of size 1 is off by
struct RayFormQuery {
  TapeView tape;
  double time, iso[kMostIsos];
  int iso_count;
  DegreeTables table;
  double slack;
  bool exact, single;
  FinderOptions finder;
};

/// The points o + t d, near <= t <= far. carried: `sides` is known at near, bit i for f < iso i.
struct alignas(64) RayFormStream {
  double o[3][kStreamSize], d[3][kStreamSize], near[kStreamSize], far[kStreamSize];
  std::uint32_t sides[kStreamSize];
  bool active[kStreamSize], carried[kStreamSize];
  int size;
};

/// Roots t with brackets; sides_at_far where none was hit.
struct RayFormRoots {
  double t[kStreamSize], lo[kStreamSize], hi[kStreamSize];
  std::uint32_t sides[kStreamSize], sides_at_far[kStreamSize];
  float steps[kStreamSize];
  std::uint8_t iso[kStreamSize];
  bool hit[kStreamSize], proved[kStreamSize];
};

}  // namespace isocast
