// A surface somewhere else: shifted, turned, scaled, sheared.
#pragma once

#include <isocast/ray/surface.h>

#include <memory>

namespace isocast {

/// Rays are carried into the surface's own space in double, with directions as they come, so that t is the
/// same in both spaces; hits are carried back. A moved surface that is moved again is carried once.
///
/// proofs   as the surface's, of the ray as it was carried, which is rounded once
/// normals  by the inverse transposed, unit length
class TransformedSurface final : public Surface {
 public:
  /// own_number  what the surface's hits say; number: what the moved one's will say
  TransformedSurface(std::shared_ptr<const Surface> surface, const Transform& world_from_own,
                     std::uint16_t own_number, std::uint16_t number);

  /// Into the surface's own space.
  [[nodiscard]] const Transform& own_from_world() const { return own_from_world_; }
  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] bool proves() const override { return surface_->proves(); }
  [[nodiscard]] bool narrow(const TileFrustum& tile) const override;
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const override;
  void find_sides(const RayStream& rays, const HitStream& hits,
                  RaySides (&sides)[kStreamSize]) const override;
  void find_edges(const PixelLines& lines, std::span<const EdgeStep> steps,
                  std::span<float> shares) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  void carry(const RayStream& rays, RayStream& own) const;
  void take_own(const RayStream& rays, const HitStream& hits, HitStream& own) const;

  std::shared_ptr<const Surface> surface_;
  Transform world_from_own_, own_from_world_;
  std::uint16_t own_number_, number_;
  Box bounds_;
};

}  // namespace isocast
