// A root that was found in a cell, and how it becomes a hit.
#pragma once

#include <isocast/math/real.h>
#include <isocast/ray/hit.h>
#include <isocast/volume/query.h>

namespace isocast::inline ISO_ISA {

/// A root in its cell, in the units of the chord from t_in to t_out; sides: as in HitStream.
struct CellRoot {
  double t_in, t_out, s = 0, s_lo = 0, s_hi = 0;
  std::int32_t cell[3];
  int iso = 0;
  bool undecided = false;
};

/// Whether a root is the hit of slot i: not where it lies behind the ray's end or a nearer hit.
ISO_HD inline double root_t(const CellRoot& root) { return root.t_in + root.s * (root.t_out - root.t_in); }
ISO_HD inline bool is_nearer(const CellRoot& root, const RayStream& rays, const HitStream& hits, int i) {
  const double t = root_t(root);
  return t <= rays.t_max[i] && t < hits.t[i];
}

/// Writes it into slot i.
ISO_HD inline void write_hit(const VolumeQuery& query, const CellRoot& root, std::uint32_t sides,
                             HitStream& hits, int i) {
  const double span = root.t_out - root.t_in;
  hits.t[i] = root_t(root);
  // what the roundings of t can make
  const double slack = query.proves ? 0x1p-50 * max(abs(root.t_in), abs(root.t_in + span)) : 0;
  hits.t_lo[i] = root.t_in + root.s_lo * span - slack;
  hits.t_hi[i] = root.t_in + root.s_hi * span + slack;
  hits.s[i] = root.s;
  hits.s_hi[i] = root.s_hi;
  for (int a = 0; a < 3; ++a) hits.cell[a][i] = root.cell[a];
  hits.iso[i] = std::uint8_t(root.iso);
  hits.object[i] = query.object;
  hits.certificate[i] = root.undecided ? Certificate::undecided
                        : query.proves ? Certificate::proved_hit
                                       : Certificate::no_proof;
  hits.sides[i] = sides;
}

}  // namespace isocast::inline ISO_ISA
