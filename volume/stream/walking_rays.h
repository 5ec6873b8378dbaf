// The rays of a stream on their way through a grid.
#pragma once

#include <isocast/ray/stream.h>

namespace isocast {

/// A ray in grid space, in the cell that it enters first.
///
/// begin, end  t_min, and the end of the ray or of the active cells
/// inverse     1 / d; along an axis where it is not finite the ray is parallel and meets no plane
/// cell        the ray's first cell, and
/// t_in        where it has entered it: through a plane of axis_in, or kStart where it starts there
struct alignas(64) WalkingRay {
  double o[3], d[3], begin, end;
  double inverse[3], cell[3], t_in, axis_in;
};

/// The same ray for a first look at boxes of cells (ray_look.h), relative to the origin of the bricks.
///
/// low, high  where it is when it enters the first cell, moved upwards and downwards by what that may be off
///            by
/// inverse    1 / d, in a unit of t that makes the least of them 1
/// end        in that unit, from the first cell on
struct alignas(64) RayLook {
  double low[3], high[3];
  float inverse[3], end;
};

/// Slot by slot as in their RayStream.
///
/// tested  cells and blocks that were looked at, up to the hit or to the end
/// ended   the ray has met its root
/// queue   the slots of the `size` rays that are to march
struct WalkingRays {
  WalkingRay ray[kStreamSize];
  RayLook look[kStreamSize];
  std::uint32_t tested[kStreamSize];
  bool ended[kStreamSize];
  std::uint16_t queue[kStreamSize];
  int size;
};

/// Active cells that rays seem to cross, those of each ray in its order, until there are enough to be solved
/// together. A ray marches on while its cells wait.
///
/// slot    of the ray
/// cell    its first corner
/// tested  of the ray, up to this cell
struct alignas(64) CellQueue {
  static constexpr int kRoom = kPacketSize + 64;  // a ray adds those of a block to less than a packet
  std::int32_t cell[3][kRoom], slot[kRoom];
  std::uint32_t tested[kRoom];
  int size;
};

/// Solves cells that wait.
class CellSolver {
 public:
  /// Takes the first kPacketSize cells out of the queue, or all; a ray whose cell holds its root is `ended`,
  /// and none of its other cells is left there.
  virtual void solve(CellQueue& queue) = 0;

 protected:
  ~CellSolver() = default;
};

/// The chords of up to 16 rays in the cells of a queue, in the cells' own coordinates (point_in_cell,
/// traverse.h).
///
/// crossed  bits: the ray does cross the cell, as the walk has it
/// first    bits: it is the ray's first one
template <class T> struct alignas(64) CellChords {
  T entry[3][kPacketSize], exit[3][kPacketSize];
  double t_in[kPacketSize], t_out[kPacketSize], axis_in[kPacketSize];
  std::uint32_t crossed, first;
};

}  // namespace isocast
