// Where rays hit, and how sure that is.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/ray/stream.h>

namespace isocast {

/// What a method says of a ray: nothing proved; a root lies in [t_lo, t_hi] and [t_min, t_lo) is empty; no
/// root at all; neither could be proved.
enum class Certificate : std::uint8_t { no_proof, proved_hit, proved_miss, undecided };

/// First hits of a RayStream, slot by slot. t is +inf where nothing was hit; then only certificate and cost
/// have a meaning.
///
/// t, t_lo, t_hi  ray parameter of the hit and its bracket, in units of the ray's direction
/// cell, s, s_hi  volumes: cell of the hit and the place in its chord, from which next_hit goes on; formulas:
///                cell[0] is the component that was hit, where that was asked for, and s and s_hi a normal
///                that the pass knows (form_normal)
/// sides          bit i set: f < iso i in front of the hit
/// cost           cells tested and cubics solved, or the evaluations of a formula
struct alignas(64) HitStream {
  double t[kStreamSize], t_lo[kStreamSize], t_hi[kStreamSize];
  double s[kStreamSize], s_hi[kStreamSize];
  std::int32_t cell[3][kStreamSize];
  std::uint32_t sides[kStreamSize];
  std::uint32_t cost[kStreamSize];
  std::uint16_t object[kStreamSize];
  std::uint8_t iso[kStreamSize];
  Certificate certificate[kStreamSize];
};

/// No hit in any slot.
ISO_HD inline void clear(HitStream& hits) {
  for (int i = 0; i < kStreamSize; ++i) {
    hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = __builtin_inf();
    hits.cost[i] = 0;
    hits.object[i] = kNoObject;
    hits.certificate[i] = Certificate::no_proof;
  }
}
ISO_HD inline bool is_hit(const HitStream& hits, int i) { return hits.t[i] < __builtin_inf(); }
/// The slot holds no hit any more.
ISO_HD inline void forget(HitStream& hits, int i) {
  hits.t[i] = __builtin_inf();
  hits.object[i] = kNoObject;
}
/// All of slot i but its cost, into slot k; or into the same one.
inline void copy_slot(const HitStream& from, int i, HitStream& to, int k) {
  to.t[k] = from.t[i], to.t_lo[k] = from.t_lo[i], to.t_hi[k] = from.t_hi[i];
  to.s[k] = from.s[i], to.s_hi[k] = from.s_hi[i];
  for (int a = 0; a < 3; ++a) to.cell[a][k] = from.cell[a][i];
  to.sides[k] = from.sides[i];
  to.object[k] = from.object[i];
  to.iso[k] = from.iso[i];
  to.certificate[k] = from.certificate[i];
}
inline void copy_slot(const HitStream& from, HitStream& to, int i) { copy_slot(from, i, to, i); }
/// Behind the hit, bit `iso` of sides has changed, unless the surface was only touched (undecided).
ISO_HD inline std::uint32_t sides_behind(const HitStream& hits, int slot) {
  return hits.certificate[slot] == Certificate::undecided ? hits.sides[slot]
                                                          : hits.sides[slot] ^ (1u << hits.iso[slot]);
}

/// Work done, summed over rays.
struct TraceCounts {
  std::int64_t cells = 0, macrocells = 0, solves = 0, evaluations = 0;
  ISO_HD TraceCounts& operator+=(const TraceCounts& other) {
    cells += other.cells;
    macrocells += other.macrocells;
    solves += other.solves;
    evaluations += other.evaluations;
    return *this;
  }
};

}  // namespace isocast
