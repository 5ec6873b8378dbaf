// Solids made of solids.
#pragma once

#include <isocast/ray/surface.h>

#include <memory>
#include <vector>

namespace isocast {

enum class CsgOperation : std::uint8_t { operand, unite, intersect, subtract };

/// A surface as a solid.
///
/// surface    made with the object number of the CSG that it is part of
/// iso_count  of its iso-values; the outermost bounds the solid, the others are surfaces inside it
/// above      the solid is where f >= iso instead of where f < iso
struct CsgOperand {
  std::shared_ptr<const Surface> surface;
  int iso_count = 1;
  bool above = false;
};

/// An operand, or what an operation makes of one part or more; `subtract`: the first without all others.
struct CsgPart {
  CsgOperation operation = CsgOperation::operand;
  CsgOperand operand;
  std::vector<CsgPart> parts;
};

/// A surface that ends at its domain as a solid: the box's faces close it. They count as one more iso-value,
/// behind the operand's.
[[nodiscard]] CsgPart closed(CsgOperand operand, const Box& box, const Transform& world_from_box,
                             std::uint16_t object);

struct CsgWalks;

/// Union, intersection and difference of solids of any kind, nested to any depth.
///
/// The crossings of a ray with all operands are taken in order of t; each changes on which side of its
/// operand the ray is (HitStream::sides; at the start find_sides), and is a hit where that changes whether
/// the ray is in the solid. Crossings at the very same t count as one. An operand's inner iso-values are hits
/// where the solid is there because of that operand.
///
/// hits    iso counts the iso-values of all operands in their order, so every operand keeps its materials.
///         sides: bits 0 to 23 of the operand that was hit, and its number from bit 24 on
/// proofs  a hit is proved where every crossing up to it, the sides of all operands and the order are; so is
///         a miss
/// cost    next_hit goes on from the last crossings that its thread has found along the same rays of the same
///         kind; the first time, and where others have come between, it begins at the rays' start
/// source  Roth: Ray casting for modeling solids, Computer Graphics and Image Processing 18(2), 1982
class CsgSurface final : public Surface {
 public:
  static constexpr int kMostIsos = 24;       // of an operand
  static constexpr int kMostOperands = 256;  // and iso-values of all

  /// Operands that are CsgSurfaces themselves become parts. Throws InputError for too many operands, and for
  /// an operation without parts.
  CsgSurface(CsgPart part, std::uint16_t object);

  [[nodiscard]] const CsgPart& part() const { return part_; }
  /// How many materials it has.
  [[nodiscard]] int iso_count() const { return iso_count_; }
  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] bool proves() const override { return proves_; }
  [[nodiscard]] bool narrow(const TileFrustum& tile) const override {
    return !bounds_.empty() && tile.may_meet(bounds_);
  }
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  friend class CsgWalk;

  CsgPart part_;
  std::vector<CsgOperand> operands_;
  std::vector<int> first_iso_;  // per operand: iso-values of those before it
  int iso_count_ = 0;
  std::shared_ptr<CsgWalks> walks_;  // of next_hit
  Box bounds_;
  bool proves_ = true;
  std::uint16_t object_;
};

}  // namespace isocast
