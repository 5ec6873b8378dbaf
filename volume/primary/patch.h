// A patch of the picture while the cells of a volume are drawn into it: its rays and what they have met so
// far.
#pragma once

#include <isocast/ray/stream.h>
#include <isocast/render/primary_ray.h>

namespace isocast {

/// Pixels per side. Rays lie row by row, kPatchPitch apart, with room for windows that reach over the border.
inline constexpr int kPatchSize = 64, kPatchPitch = 68, kPatchRays = kPatchPitch * (kPatchSize + 4);
/// Pixels per side of the parts whose farthest hit is known.
inline constexpr int kPartSize = 8, kPatchParts = kPatchSize / kPartSize;

/// Pixels x_lo...x_hi, y_lo...y_hi of a patch; empty where lo > hi.
struct PixelBox {
  std::int32_t x_lo, x_hi, y_lo, y_hi;
};

/// A ray in grid space (t_min = 0), with the bits that the walk has, and what it has met.
///
/// own    perspective: its direction; orthographic: its origin. All rays of a patch share the other one
/// other  perspective: the inverse of its direction; orthographic: the number of the cells that it keeps to
///        along axes that it is parallel to
/// depth  t_in of the cell of the nearest root so far; before, as far as anything matters
/// axis   of the entry into that cell, kNoHit before
struct alignas(64) PatchRay {
  double own[3], other[3], depth, axis;
};
inline constexpr double kNoHit = 255;

/// What the rays of a patch share, and what a first look at them needs.
///
/// quick         in float, for a first look (windows.h). Perspective: `inverse` times the unit of t;
/// orthographic:
///               where the ray starts, from `corner` on, times shared_quick
/// shared_quick  orthographic: shared_inverse times the unit of t; 0 along axes that a first look cannot use
/// reach         orthographic: no ray's |quick| is larger
struct alignas(64) PatchLook {
  float quick[3][kPatchRays];
  double shared[3], shared_inverse[3];
  double corner[3], shared_quick[3], reach[3];
  bool parallel[3];
};

/// A root: its cell and iso-value, and its place on the chord of the cell, from s_lo to s_hi.
struct alignas(64) PatchHit {
  double t_in, t_out, s, s_lo, s_hi;
  std::int32_t cell[3];
  std::uint8_t iso;
  bool undecided, behind;
};

/// Pairs of a ray and an active cell that it seems to cross, until there are enough to be solved together;
/// cell: its slot in the ring.
struct alignas(64) PairQueue {
  static constexpr int kRoom = 3 * kPacketSize;  // a window adds so many numbers to less than a packet's
  std::int32_t ray[kRoom], cell[kRoom];
  int size;
};

/// The last cells that rays were queued for: less than a packet's pairs wait whenever one is added. f:
/// corners minus iso; at: the first corner.
template <class T> struct alignas(64) CellRing {
  static constexpr int kSlots = kPacketSize;
  T f[8][kSlots];
  std::int32_t at[3][kSlots];
  std::int32_t iso[kSlots];
  bool doubtful[kSlots];
  unsigned next;
};

/// frame, unit          the picture's, and its ScreenMap's
/// x, y, columns, rows  the patch in the picture
/// limit                not less than the depth, in the unit of t
/// met, walk            rows of bits: rays that have met something, and those that only the walk can answer
/// far                  the largest limit of each part, where its bit in `stale` is not set
struct PatchState {
  RayFrame frame;
  double unit;
  int x, y, columns, rows;
  double offset_u, offset_v;
  PatchRay rays[kPatchRays];
  PatchLook look;
  alignas(64) float limit[kPatchRays];
  std::uint64_t met[kPatchSize], walk[kPatchSize];
  PatchHit hits[kPatchRays];
  float far[kPatchParts * kPatchParts];
  std::uint64_t stale;
  PairQueue queue;
  union {
    CellRing<float> cells_float;
    CellRing<double> cells_double;
  };
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// Only the walk can answer the ray.
inline void leave_to_walk(PatchState& patch, int ray) {
  patch.walk[ray / kPatchPitch] |= std::uint64_t(1) << ray % kPatchPitch;
}

/// Nothing behind t matters on a ray any more.
inline void set_depth(PatchState& patch, int ray, double t) {
  constexpr float kAbove = 1 + 0x1p-20f;
  patch.rays[ray].depth = t;
  patch.limit[ray] = kAbove * static_cast<float>(t * patch.unit);
}

}  // namespace isocast::inline ISO_ISA
