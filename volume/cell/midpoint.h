// Midpoint: every cell whose corners enclose the iso-value is hit in its middle.
#pragma once

#include <isocast/volume/cell/cell.h>

namespace isocast::inline ISO_ISA {

/// s = 1/2 when corners of both signs exist (zero counts as positive). No evaluation of f: off by up to half
/// the chord, and a hit wherever the ray enters such a cell. The bracket is what is left of the chord. source
/// Marmitt et al., Fast and accurate ray-voxel intersection techniques for iso-surface ray tracing, VMV 2004
template <Real R> ISO_HD inline Root<R> midpoint(const Cell<R>& cell, const CellOptions&) {
  Mask<R> some = negative(cell.f[0]), all = some;
  for (int i = 1; i < 8; ++i) {
    some = some | negative(cell.f[i]);
    all = all & negative(cell.f[i]);
  }
  const Mask<R> hit = some & (!all) & (cell.begin < R(0.5));
  return {R(0.5), cell.begin, R(1), hit, Mask<R>(false), negative(trilinear(cell.f, cell.exit))};
}

}  // namespace isocast::inline ISO_ISA
