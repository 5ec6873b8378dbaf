// Where rays are in a solid and in its operands.
#pragma once

#include <isocast/ray/csg_surface.h>

#include <bitset>

namespace isocast {

/// Some of the rays of a stream.
using RaySet = std::bitset<kStreamSize>;

/// On which sides of every operand each ray of a stream is, and what follows from it for the solid. All rays
/// begin below nothing.
class CsgSides {
 public:
  /// part, operands: of the solid, which outlive this.
  CsgSides(const CsgPart& part, const std::vector<CsgOperand>& operands);

  /// Bit n set: ray i is where f < iso n of operand k.
  [[nodiscard]] std::uint32_t of(std::size_t k, int i) const { return places_[k].below[i]; }
  void set(std::size_t k, int i, std::uint32_t below);
  /// Ray i stays on the sides of operand k on which it is now.
  void stay(std::size_t k, int i) { places_[k].stays.set(static_cast<std::size_t>(i)); }

  [[nodiscard]] const RaySet& in_operand(std::size_t k) const { return places_[k].inside; }
  /// The rays that are in the solid.
  [[nodiscard]] RaySet inside() const;
  /// The same if nothing were in operand k.
  [[nodiscard]] RaySet inside_without(std::size_t k);
  /// The rays that are in the solid for ever or never will be, whatever the operands are in which they do
  /// not stay as they are.
  [[nodiscard]] RaySet settled() const;

 private:
  struct Place {
    std::uint32_t below[kStreamSize] = {};
    RaySet inside, stays;
  };
  struct Known;
  template <class OfOperand> Known combine(const CsgPart& part, std::size_t& k, OfOperand of_operand) const;
  template <class OfOperand> Known combine(OfOperand of_operand) const;

  const CsgPart& part_;
  const std::vector<CsgOperand>& operands_;
  std::vector<Place> places_;  // per operand
};

}  // namespace isocast
