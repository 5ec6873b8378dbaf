// What is there of a hidden object.
#pragma once

#include <isocast/ray/surface.h>

namespace isocast {

/// Nothing, which is proved to be missed.
class NoSurface final : public Surface {
 public:
  [[nodiscard]] Box bounds() const override { return {}; }
  [[nodiscard]] bool proves() const override { return true; }
  [[nodiscard]] bool narrow(const TileFrustum& /*tile*/) const override { return false; }
  void first_hit(const RayStream& /*rays*/, HitStream& /*hits*/, TraceCounts& /*counts*/) const override {}
  void next_hit(const RayStream& /*rays*/, HitStream& /*hits*/, TraceCounts& /*counts*/) const override {}
  void dress(const RayStream& /*rays*/, const HitStream& /*hits*/, const DressWishes& /*wishes*/,
             DressedHits& /*dressed*/) const override {}
};

}  // namespace isocast
