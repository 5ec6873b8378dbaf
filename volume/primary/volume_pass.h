// Primary rays of a volume in object order: its active cells are drawn into the picture.
#pragma once

#include <isocast/ray/primary_pass.h>
#include <isocast/render/camera.h>
#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/primary/bricks_in_view.h>
#include <isocast/volume/primary/kernels.h>
#include <oneapi/tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

namespace isocast {

/// Every pair of a ray and an active cell that it crosses has the chord, the cubic and the root that the walk
/// gives it, with the same bits, and the first root by the walk's order of cells wins: so the hits are those
/// of the walk (without their cost). The few rays that this order does not hold for are left to the walk.
class VolumePass final : public PrimaryPass {
 public:
  /// masks  one for each iso-value of the query, which outlives the pass
  VolumePass(const VolumeQuery& query, std::vector<std::shared_ptr<const IsoMasks>> masks, const View& view,
             BricksInView bricks, Isa isa);

  /// The cost of a ray is the walk's work.
  [[nodiscard]] bool tells_cost() const override { return false; }
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  using Scratch = std::unique_ptr<PatchState>;

  void trace_patch(int px, int py, BlockHits& hits, PatchState& patch, TraceCounts& counts) const;
  [[nodiscard]] unsigned fill_tiles(const PixelBox& pixels, unsigned filled, BlockHits& hits,
                                    PatchState& patch) const;
  void write_tile(int x, int y, const PatchState& patch, BlockHits& hits, TraceCounts& counts) const;

  const VolumeQuery& query_;
  std::vector<std::shared_ptr<const IsoMasks>> masks_;
  View view_;
  BricksInView bricks_;
  const PrimaryKernels& kernels_;
  mutable oneapi::tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace isocast
