// Primary rays that a pass over the picture cannot tell.
#pragma once

#include <isocast/ray/surface.h>

namespace isocast {

/// Gathers them from the tiles of a block, to solve them by the surface's first_hit as rays that no view
/// orders.
///
/// hits   must live until they are solved; one that is nearer stays
/// proofs the surface's; what it cannot prove becomes undecided
class OpenRays {
 public:
  /// The thread's own, empty.
  [[nodiscard]] static OpenRays& of_thread(const Surface& surface);

  /// The tile that rays come from now.
  void begin(const View& view, int tx, int ty, double offset_u, double offset_v, HitStream& hits);
  /// The tile's ray i, whose roots before the distance `from` along it are known; solves them when they are
  /// as many as a stream holds.
  void add(int i, double from, TraceCounts& counts);
  void solve(TraceCounts& counts);

 private:
  const Surface* surface_ = nullptr;
  const View* view_ = nullptr;
  int tx_ = 0, ty_ = 0;
  double offset_u_ = 0, offset_v_ = 0;
  bool filled_ = false;
  HitStream* tile_hits_ = nullptr;
  RayStream tile_, rays_;
  HitStream hits_;
  HitStream* to_[kStreamSize];
  int slot_[kStreamSize];
};

}  // namespace isocast
