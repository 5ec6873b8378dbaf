// A surface whose primary rays are found by first_hit alone.
#pragma once

#include <isocast/ray/surface.h>

namespace isocast::bench {

/// The same surface without its own order of primary rays; refers to it.
class WalkedSurface final : public Surface {
 public:
  explicit WalkedSurface(const Surface& surface) : surface_(surface) {}

  [[nodiscard]] Box bounds() const override { return surface_.bounds(); }
  [[nodiscard]] bool proves() const override { return surface_.proves(); }
  [[nodiscard]] bool narrow(const TileFrustum& tile) const override { return surface_.narrow(tile); }
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override {
    surface_.first_hit(rays, hits, counts);
  }
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override {
    surface_.next_hit(rays, hits, counts);
  }
  void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const override {
    surface_.any_hit(rays, hit, counts);
  }
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override {
    surface_.dress(rays, hits, wishes, dressed);
  }

 private:
  const Surface& surface_;
};

}  // namespace isocast::bench
