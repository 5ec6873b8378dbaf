// The rays of a stream on their way through a grid.
#pragma once

#include <isocast/ray/stream.h>

namespace isocast {

/// Rays in grid space, slot by slot as in their RayStream, each in a cell.
///
/// inverse  1 / d; along an axis where it is not finite a ray is parallel and meets no plane
/// cell     the ray's cell, and
/// t_in     where it has entered it: through a plane of axis_in, or kStart where it starts there
/// t_end    the end of the ray or of the active cells
/// tested   cells whose bits were looked at
/// fresh    the ray has not been in another cell before, and this one has not been looked at
/// queue    the slots of the first `size` rays: those that are to march, or those that have found a cell
struct alignas(64) WalkingRays {
  double o[3][kStreamSize], d[3][kStreamSize], inverse[3][kStreamSize];
  double cell[3][kStreamSize], t_in[kStreamSize], axis_in[kStreamSize], t_end[kStreamSize];
  std::uint32_t tested[kStreamSize];
  bool fresh[kStreamSize];
  std::uint16_t queue[kStreamSize];
  int size;
};

/// The chords of up to 16 rays in their cells, in the cells' own coordinates (point_in_cell, traverse.h).
struct alignas(64) CellChords {
  double entry[3][kPacketSize], exit[3][kPacketSize], t_in[kPacketSize], t_out[kPacketSize];
  int axis_in[kPacketSize];
  std::int32_t cell[kPacketSize][3];
};

}  // namespace isocast
