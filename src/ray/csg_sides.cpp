#include <isocast/ray/csg_sides.h>

#include <utility>

namespace isocast {

// The rays that are surely inside and surely outside.
struct CsgSides::Known {
  RaySet inside, outside;
};

CsgSides::CsgSides(const CsgPart& part, const std::vector<CsgOperand>& operands)
    : part_(part), operands_(operands), places_(operands.size()) {
  for (std::size_t k = 0; k < operands.size(); ++k)
    if (operands[k].above) places_[k].inside.set();
}

void CsgSides::set(std::size_t k, int i, std::uint32_t below) {
  const std::uint32_t all = (1u << operands_[k].iso_count) - 1;
  places_[k].below[i] = below;
  places_[k].inside.set(static_cast<std::size_t>(i),
                        operands_[k].above ? (below & all) != all : (below & all) != 0);
}

// What is known of a part, from what is known of its operands: those from number k on.
template <class OfOperand>
CsgSides::Known CsgSides::combine(const CsgPart& part, std::size_t& k, OfOperand of_operand) const {
  if (part.operation == CsgOperation::operand) return of_operand(k++);
  Known all = combine(part.parts[0], k, of_operand);
  for (std::size_t n = 1; n < part.parts.size(); ++n) {
    Known one = combine(part.parts[n], k, of_operand);
    if (part.operation == CsgOperation::subtract) std::swap(one.inside, one.outside);
    if (part.operation == CsgOperation::unite) all.inside |= one.inside, all.outside &= one.outside;
    else all.inside &= one.inside, all.outside |= one.outside;
  }
  return all;
}
template <class OfOperand> CsgSides::Known CsgSides::combine(OfOperand of_operand) const {
  std::size_t k = 0;
  return combine(part_, k, of_operand);
}

RaySet CsgSides::inside() const {
  return combine([&](std::size_t k) { return Known{places_[k].inside, ~places_[k].inside}; }).inside;
}

RaySet CsgSides::inside_without(std::size_t k) {
  const RaySet kept = std::exchange(places_[k].inside, RaySet());
  const RaySet without = inside();
  places_[k].inside = kept;
  return without;
}

RaySet CsgSides::settled() const {
  const Known known = combine([&](std::size_t k) {
    const Place& place = places_[k];
    return Known{place.inside & place.stays, ~place.inside & place.stays};
  });
  return known.inside | known.outside;
}

}  // namespace isocast
