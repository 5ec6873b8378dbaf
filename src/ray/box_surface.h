// A box as a solid.
#pragma once

#include <isocast/ray/surface.h>

namespace isocast {

/// The faces of a box anywhere in the world: what closes a surface that ends at its domain. Its f is negative
/// inside.
///
/// proofs  of the box that `box_from_world` maps to [lo, hi], as it is stored
class BoxSurface final : public Surface {
 public:
  /// object  number of the surface in its scene
  BoxSurface(const Box& box, const Transform& world_from_box, std::uint16_t object);
  BoxSurface(const Box& box, std::uint16_t object) : BoxSurface(box, Transform(), object) {}

  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] bool proves() const override { return true; }
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  /// value: 0, as everywhere on the faces.
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  struct Chord;
  [[nodiscard]] Chord chord(const RayStream& rays, int i) const;
  void write(const Chord& chord, bool leaves, int i, HitStream& hits) const;

  Box box_, bounds_;
  Transform box_from_world_;
  std::uint16_t object_;
};

}  // namespace isocast
