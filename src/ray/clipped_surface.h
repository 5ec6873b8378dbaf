// The part of a surface that lies in solids.
#pragma once

#include <isocast/ray/region.h>
#include <isocast/ray/stretch.h>
#include <isocast/ray/surface.h>

#include <memory>
#include <vector>

namespace isocast {

/// What lies in all of the regions: of the crossings of a ray with the surface the others are passed over.
/// The regions are looked at where the surface was hit; and rays are cut before to where the regions that
/// can tell may be (Region::narrow). What is cut open stays open.
///
/// proofs  as the surface's; a hit is proved where it is sure to lie inside, and what is passed over before
///         it sure to lie outside
/// source  constructive solids by conditions: Knoll et al.: Fast ray tracing of arbitrary implicit surfaces
///         with interval and affine arithmetic, Computer Graphics Forum 28(1), 2009
class ClippedSurface final : public Surface {
 public:
  /// object  number of the surface in its scene
  ClippedSurface(std::shared_ptr<const Surface> surface, std::vector<std::shared_ptr<const Region>> regions,
                 std::uint16_t object);

  [[nodiscard]] Box bounds() const override { return surface_->bounds(); }
  [[nodiscard]] bool proves() const override { return surface_->proves(); }
  [[nodiscard]] bool narrow(const TileFrustum& tile) const override { return surface_->narrow(tile); }
  /// The surface's, where it has one (render/clipped_pass.h).
  [[nodiscard]] std::unique_ptr<PrimaryPass> primary(const View& view) const override;
  /// As first_hit, where the first hits of the surface itself are known: `whole`. Only rays whose hits lie
  /// outside, or are not sure, are looked at again.
  void first_hit_inside(const RayStream& rays, const HitStream& whole, HitStream& hits,
                        TraceCounts& counts) const;
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override {
    surface_->dress(rays, hits, wishes, dressed);
  }

 private:
  void locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const;
  void follow(const RayStream& rays, Stretch (&stretches)[kStreamSize], HitStream& open,
              TraceCounts& counts) const;
  void pass_over(const RayStream& rays, HitStream& hits, TraceCounts& counts) const;

  [[nodiscard]] std::unique_ptr<RayStream> narrowed(const RayStream& rays) const;

  std::shared_ptr<const Surface> surface_;
  std::vector<std::shared_ptr<const Region>> regions_;
  std::uint16_t object_;
};

}  // namespace isocast
