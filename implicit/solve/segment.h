// Segments of the rays of a stream and the roots on them: the plain data that formula kernels read and write.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/isa/isa.h>
#include <isocast/ray/stream.h>

namespace isocast {

inline constexpr int kMostIsos = 16;

/// The points e + s d, 0 <= s <= 1, ray by ray; every true point lies within `slack` of it, axis by axis, and
/// so does the true direction of d.
///
/// begin     roots are sought in [begin, 1]
/// smallest  parts of this length, in s, are not divided without need
/// active    a segment is here
/// carried   `sides` is known at `begin`, where f is not evaluated: bit i tells whether f < iso i there
/// given     no root lies before [0, 1], and there one crossing, of iso-value `given_iso`, from `sides`: all
/// is
///           proved already
/// together  a packet's rays are divided at the same points of one axis: s = k_offset + k_scale k, 0 <= k <=
/// 1
template <class T> struct alignas(64) SegmentStream {
  T e[3][kStreamSize], d[3][kStreamSize], slack[3][kStreamSize];
  T begin[kStreamSize], smallest[kStreamSize], k_offset[kStreamSize], k_scale[kStreamSize];
  std::uint32_t sides[kStreamSize];
  std::uint8_t given_iso[kStreamSize];
  bool active[kStreamSize], carried[kStreamSize], given[kStreamSize];
  bool together[kStreamSize / kPacketSize];
  int size;
};

/// Rays first to last - 1 of a stream.
struct RayRange {
  int first, last;
};

/// What was found on a segment.
///
/// s_lo, s_hi   the first root lies between, and s is the best guess at it
/// sides        bit i: f < iso i at s_lo
/// iso          the iso-value that is reached
/// evaluations  of the tape, over boxes and points
/// hit, proved  a root was found; what is said (a hit or none) is proved
template <class T> struct alignas(64) SegmentRoots {
  T s[kStreamSize], s_lo[kStreamSize], s_hi[kStreamSize];
  std::uint32_t sides[kStreamSize], evaluations[kStreamSize];
  std::uint8_t iso[kStreamSize];
  bool hit[kStreamSize], proved[kStreamSize];
};

/// Which parts of a ray f's derivative is asked about: small ones; all (Mitchell); all, and where it excludes
/// zero an interval Newton step tells what is left of the part.
enum class Derivative : std::uint8_t { of_small, of_all, newton };

/// delta       parts over which f varies by no more are taken for hits, without proof
/// trim        affine: the part of a segment that its form proves empty is left out before it is divided
/// packets     rays of a packet are divided at the same points of one axis, where they can be
/// derivative  interval
/// tau         marching points: the thresholds of |f|, |f| and |df/dt|
/// step        marching points: the base step, a world length
/// halvings    marching points: bisections of the step that holds a root
struct FormulaOptions {
  bool trim = true, packets = false;
  Derivative derivative = Derivative::of_small;
  double delta = 0, tau[3] = {}, step = 0;
  int halvings = 10;
};

/// iso   each iso-value lies between iso_lo and iso_hi
/// time  the variable w
template <class T> struct FormulaQuery {
  TapeView tape;
  T iso_lo[kMostIsos], iso_hi[kMostIsos];
  int iso_count;
  double time;
  FormulaOptions options;
};

/// Iso-values of a query: a number that the compiler knows where kernels are compiled for one formula
/// (ISO_ISOS).
template <class T> ISO_HD constexpr int isos_in([[maybe_unused]] const FormulaQuery<T>& query) {
#ifdef ISO_ISOS
  return ISO_ISOS;
#else
  return query.iso_count;
#endif
}

}  // namespace isocast
