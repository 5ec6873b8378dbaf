// A patch of the picture while the cells of a volume are drawn into it: its rays and what they have met so
// far.
#pragma once

#include <isocast/ray/stream.h>
#include <isocast/render/primary_ray.h>

namespace isocast {

/// Pixels per side. Rays lie row by row, kPatchPitch apart, with room for windows that reach over the border.
inline constexpr int kPatchSize = 64, kPatchPitch = 68, kPatchRays = kPatchPitch * (kPatchSize + 2);
/// Pixels per side of the parts whose farthest hit is known.
inline constexpr int kPartSize = 8, kPatchParts = kPatchSize / kPartSize;

/// Pixels x_lo...x_hi, y_lo...y_hi of a patch; empty where lo > hi.
struct PixelBox {
  std::int32_t x_lo, x_hi, y_lo, y_hi;
};
constexpr bool is_empty(const PixelBox& box) { return box.x_lo > box.x_hi || box.y_lo > box.y_hi; }

/// The rays in grid space (t_min = 0), with the bits that the walk has. Perspective: they share `origin`, and
/// `direction` and `inverse` are their own; orthographic: the reverse, and `cell` is the number of the cells
/// that a ray keeps to along axes that it is parallel to.
struct alignas(64) PatchRays {
  double own[3][kPatchRays], inverse[3][kPatchRays], cell[3][kPatchRays];
  double shared[3], shared_inverse[3];
  bool parallel[3];
};

/// A root: its cell and iso-value, and its place on the chord of the cell, from s_lo to s_hi.
struct PatchHit {
  double t_out, s, s_lo, s_hi;
  std::int32_t cell[3];
  std::uint8_t iso;
  bool undecided, behind;
};

/// Pairs of a ray and an active cell that it crosses, until there are enough to be solved together: corners
/// minus iso, and what the walk knows of the cell. axis: that of the entry, or kStart.
template <class T> struct alignas(64) PairQueue {
  static constexpr int kRoom = 2 * kPacketSize + 8;
  T f[8][kRoom], entry[3][kRoom], exit[3][kRoom];
  double t_in[kRoom], t_out[kRoom], axis[kRoom], ray[kRoom];
  std::int32_t cell[3][kRoom], iso[kRoom];
  int size;
  bool any_start;
};

/// frame                the picture's
/// x, y, columns, rows  the patch in the picture
/// depth                t_in of the cell of the nearest root so far; before, as far as anything matters
/// axis                 its entry axis, 255 before
/// walk                 rays that only the walk can answer
/// far                  the largest depth of each part, where its bit in `stale` is not set
struct PatchState {
  RayFrame frame;
  int x, y, columns, rows;
  double offset_u, offset_v;
  PatchRays rays;
  alignas(64) double depth[kPatchRays];
  std::uint8_t axis[kPatchRays], walk[kPatchRays];
  PatchHit hits[kPatchRays];
  double far[kPatchParts * kPatchParts];
  std::uint64_t stale;
  union {
    PairQueue<float> pairs_float;
    PairQueue<double> pairs_double;
  };
};

}  // namespace isocast
