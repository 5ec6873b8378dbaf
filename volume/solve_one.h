// One ray in one cell through the query's intersector: how a GPU's threads solve, and what they are tested
// by.
#pragma once

#include <isocast/volume/cell/certified.h>
#include <isocast/volume/cell/linear.h>
#include <isocast/volume/cell/marmitt.h>
#include <isocast/volume/cell/midpoint.h>
#include <isocast/volume/cell/neubauer.h>
#include <isocast/volume/cell/packet.h>
#include <isocast/volume/cell/schwarze.h>
#include <isocast/volume/query.h>

namespace isocast::inline ISO_ISA {

/// The intersector of a method; the bits of the tables in cell/kernels.h.
template <class T>
ISO_HD inline Root<T> intersect_by(CellMethod method, const Cell<T>& cell, const CellOptions& options) {
  switch (method) {
    case CellMethod::midpoint: return midpoint(cell, options);
    case CellMethod::linear: return linear(cell, options);
    case CellMethod::neubauer: return neubauer(cell, options);
    case CellMethod::schwarze: return schwarze(cell, options);
    case CellMethod::marmitt: return marmitt(cell, options);
    default: return certified(cell, options);
  }
}

/// A packet of one lane, which is active.
template <class T>
ISO_HD inline void solve_packet(const VolumeQuery& query, const CellPacket<T, 1>& packet,
                                RootPacket<T, 1>& roots) {
  Cell<T> cell;
  for (int k = 0; k < 8; ++k) cell.f[k] = packet.f[k][0];
  cell.entry = {packet.entry[0][0], packet.entry[1][0], packet.entry[2][0]};
  cell.exit = {packet.exit[0][0], packet.exit[1][0], packet.exit[2][0]};
  cell.begin = packet.begin[0];
  cell.carry = packet.carry[0];
  cell.slack = packet.slack[0];
  const Root<T> root = intersect_by(query.method, cell, query.options);
  roots.s[0] = root.s;
  roots.s_lo[0] = root.s_lo;
  roots.s_hi[0] = root.s_hi;
  roots.hit = root.hit;
  roots.undecided = root.undecided;
  roots.sign = root.sign_behind;
  roots.proved = root.proved;
}

}  // namespace isocast::inline ISO_ISA
