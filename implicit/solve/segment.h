// Sixteen segments of rays and the roots on them: the plain data that formula kernels read and write.
#pragma once

#include <isocast/implicit/expression/instruction.h>

namespace isocast {

inline constexpr int kSegments = 16;
inline constexpr int kMostIsos = 16;

/// The points e + s d, 0 <= s <= 1, a lane each; e and d lie between the two numbers given for them.
///
/// begin      roots are sought in [begin, 1]
/// sides      where the bit of the lane in `carried` is set: bit i tells whether f < iso i at `begin`, where
/// f
///            is not evaluated
/// smallest   segments of this length, in s, are not divided without need
/// active     bit l set: lane l holds a segment
template <class T> struct alignas(64) SegmentPacket {
  T e_lo[3][kSegments], e_hi[3][kSegments], d_lo[3][kSegments], d_hi[3][kSegments];
  T begin[kSegments], smallest[kSegments];
  std::uint32_t sides[kSegments];
  std::uint32_t carried, active;
};

/// s             first root; it lies in [s_lo, s_hi]
/// sides         bit i: f < iso i at s_lo
/// iso           the iso-value that is reached
/// evaluations   of the tape, over boxes and points
/// hit, proved   bits: a root was found; what is said (a hit or none) is proved
/// crossing      of the hits: f changes sign there
template <class T> struct alignas(64) SegmentRoots {
  T s[kSegments], s_lo[kSegments], s_hi[kSegments];
  std::uint32_t sides[kSegments], evaluations[kSegments];
  std::uint8_t iso[kSegments];
  std::uint32_t hit, proved, crossing;
};

enum class FormulaMethod : std::uint8_t { interval, affine };
inline constexpr int kFormulaMethodCount = 2;

/// trim  affine: the part of a segment that its form proves empty is left out before it is divided
struct FormulaOptions {
  bool trim = true;
};

/// iso   each iso-value lies between the two numbers
/// time  the variable w
template <class T> struct FormulaQuery {
  TapeView tape;
  T iso_lo[kMostIsos], iso_hi[kMostIsos];
  int iso_count;
  double time;
  FormulaOptions options;
};

}  // namespace isocast
