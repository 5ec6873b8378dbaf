// Linear: f at entry and exit, and the zero of the line between.
#pragma once

#include <isocast/volume/cell/cell.h>

namespace isocast::inline ISO_ISA {

/// f at a point of the cell's faces: trilinear, or bilinear on the face with `face`.
template <Real R>
ISO_HD inline R value_on_face(const Cell<R>& cell, const Vec3<R>& p, const CellOptions& options) {
  return options.face ? bilinear_on_face(cell.f, p) : trilinear(cell.f, p);
}

/// The part of the chord that is left, with f at both ends; `hit` where the signs differ.
template <Real R> struct EndValues {
  Bracket<R> bracket;
  Mask<R> hit;
};
template <Real R> ISO_HD inline EndValues<R> end_values(const Cell<R>& cell, const CellOptions& options) {
  const R at_entry = value_on_face(cell, cell.entry, options);
  const Mask<R> inside = cell.begin > R(0);
  const R at_begin =
      any(inside) ? select(inside, trilinear(cell.f, point_at(cell, cell.begin)), at_entry) : at_entry;
  const R flo = with_carried_sign(cell, at_begin), fhi = value_on_face(cell, cell.exit, options);
  return {{cell.begin, R(1), flo, fhi}, negative(flo) != negative(fhi)};
}

/// Misses two roots in a cell; of three roots it gives one point between them.
/// source  Marmitt et al., VMV 2004, "linear"
template <Real R> ISO_HD inline Root<R> linear(const Cell<R>& cell, const CellOptions& options) {
  const EndValues<R> ends = end_values(cell, options);
  return {chord_zero(ends.bracket), cell.begin, R(1), ends.hit, Mask<R>(false), negative(ends.bracket.fhi)};
}

}  // namespace isocast::inline ISO_ISA
