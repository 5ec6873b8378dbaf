// The primary rays of a picture of a surface that solids cut.
#pragma once

#include <isocast/ray/clipped_surface.h>
#include <isocast/ray/primary_pass.h>
#include <isocast/render/camera.h>

namespace isocast {

/// The pass of the surface itself finds most hits; rays whose hits are cut away go on by ClippedSurface.
class ClippedPass final : public PrimaryPass {
 public:
  /// surface  must outlive the pass, and what it cuts as well; pass: of what it cuts
  ClippedPass(const ClippedSurface& surface, const View& view, std::unique_ptr<PrimaryPass> pass)
      : surface_(surface), view_(view), pass_(std::move(pass)) {}

  [[nodiscard]] bool tells_cost() const override { return pass_->tells_cost(); }
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  const ClippedSurface& surface_;
  const View& view_;
  std::unique_ptr<PrimaryPass> pass_;
};

}  // namespace isocast
