// The cells that up to sixteen rays have come to, solved for all iso-values: what the walk, streams and the
// GPU (one ray a packet) share.
#pragma once

#include <isocast/math/lanes.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/cell_root.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

// What is asked of `cells`, the cells of up to kLanes rays, one a lane; a packet of that many lanes needs an
// overload of solve_packet(query, packet, roots) (solve_packet.h, solve_one.h):
//   holding(iso, lanes)    those of the lanes whose cell holds an iso-value
//   fetch(iso, lanes, packet, doubtful)
//                          corners minus iso, chords and starts of the cells of `lanes` into the packet;
//                          returns those whose corners are finite, and adds to `doubtful` those of methods
//                          that prove whose cell exists though its corners minus iso are too large
//   starts(l)              the ray starts in its cell, and its signs there are not known
//   known_sides(l, sides)  whether they are, and which (HitStream::sides)
//   place(l)               the cell and its chord as a CellRoot without a root
//   doubt(l)               something before this cell was not proved

/// f at the entry of a lane's cell, as the intersectors see it.
template <class T, int N> ISO_HD inline T value_at_entry(const CellPacket<T, N>& packet, int l) {
  T f[8];
  for (int k = 0; k < 8; ++k) f[k] = packet.f[k][l];
  return trilinear<T>(f, Vec3<T>{packet.entry[0][l], packet.entry[1][l], packet.entry[2][l]});
}

/// The start of a lane's cell for an iso-value: roots are sought behind `begin`, and the sign there is known
/// where `known`.
template <class T, int N>
ISO_HD inline void set_start(CellPacket<T, N>& packet, int l, double begin, bool known, std::uint32_t sides,
                             int iso) {
  packet.begin[l] = T(begin);
  packet.carry[l] = known ? (sides >> iso & 1 ? T(-0.0) : T(0)) : T(__builtin_nan(""));
}

/// Sides of all iso-values in front of the hit of iso `hit_iso`; `behind`: f is negative behind it,
/// `touched`: so it is in front. All of the cell has one side of those that it does not hold, though it holds
/// the one that was hit.
template <class T, class Cells>
ISO_HD inline std::uint32_t sides_in_front(const VolumeQuery& query, const Cells& cells, int l, int hit_iso,
                                           bool behind, bool touched) {
  std::uint32_t sides = std::uint32_t(behind == touched) << hit_iso, known = 0, doubtful = 0;
  const bool carried = cells.known_sides(l, known);
  CellPacket<T, Cells::kLanes> packet;
  for (int i = 0; i < query.iso_count; ++i) {
    if (i == hit_iso) continue;
    if (carried) sides |= known & 1u << i;
    else if (!cells.holding(i, 1u << l)) sides |= std::uint32_t(query.iso[hit_iso] < query.iso[i]) << i;
    else if (cells.fetch(i, 1u << l, packet, doubtful))
      sides |= std::uint32_t(negative(value_at_entry(packet, l))) << i;
  }
  return sides;
}

/// The nearest root among the iso-values in each lane's cell. unproved: that it is this one, or that there is
/// none.
template <class T, int N = kPacketSize> struct Nearest {
  T s[N], s_lo[N], s_hi[N];
  int iso[N];
  std::uint32_t hit = 0, undecided = 0, behind = 0, unproved = 0;
};
template <class T, int N, class Cells>
ISO_HD inline Nearest<T, N> solve_cells(const VolumeQuery& query, const Cells& cells, std::uint32_t alive,
                                        std::uint32_t* cost, CellPacket<T, N>& packet,
                                        RootPacket<T, N>& roots, TraceCounts& counts) {
  Nearest<T, N> nearest;
  for (int i = 0; i < query.iso_count; ++i) {
    packet.active = cells.fetch(i, cells.holding(i, alive), packet, nearest.unproved);
    if (packet.active == 0) continue;
    for_lanes<N>(packet.active, [&](int l) { ++cost[l]; });
    counts.solves += count_bits(packet.active);
    solve_packet(query, packet, roots);
    nearest.unproved |= packet.active & ~roots.proved;

    // exactly zero at the very start of a ray is a hit there; the side behind is the positive one
    for_lanes<N>(packet.active, [&](int l) {
      if (!cells.starts(l) || value_at_entry(packet, l) != T(0)) return;
      roots.s[l] = roots.s_lo[l] = roots.s_hi[l] = T(0);
      roots.hit |= 1u << l;
      roots.undecided |= 1u << l;
      roots.sign &= ~(1u << l);
    });
    for_lanes<N>(roots.hit, [&](int l) {
      const std::uint32_t bit = 1u << l;
      if ((nearest.hit & bit) && roots.s_lo[l] < nearest.s_hi[l] && nearest.s_lo[l] < roots.s_hi[l])
        nearest.unproved |= bit;
      if ((nearest.hit & bit) && !(roots.s[l] < nearest.s[l])) return;
      nearest.s[l] = roots.s[l];
      nearest.s_lo[l] = roots.s_lo[l];
      nearest.s_hi[l] = roots.s_hi[l];
      nearest.iso[l] = i;
      nearest.hit |= bit;
      nearest.undecided = (nearest.undecided & ~bit) | (roots.undecided & bit);
      nearest.behind = (nearest.behind & ~bit) | (roots.sign & bit);
    });
  }
  return nearest;
}

/// Writes the root of lane l into the hit of slot i, unless it lies behind the ray's end or a nearer hit.
template <class T, int N, class Cells>
ISO_HD inline void record_hit(const VolumeQuery& query, const Cells& cells, const Nearest<T, N>& nearest,
                              int l, const RayStream& rays, HitStream& hits, int i) {
  CellRoot root = cells.place(l);
  root.s = double(nearest.s[l]);
  root.s_lo = double(nearest.s_lo[l]);
  root.s_hi = double(nearest.s_hi[l]);
  root.iso = nearest.iso[l];
  root.undecided = (nearest.undecided >> l & 1) || (query.proves && cells.doubt(l));
  if (is_nearer(root, rays, hits, i))
    write_hit(query, root,
              sides_in_front<T>(query, cells, l, root.iso, nearest.behind >> l & 1, root.undecided), hits, i);
}

}  // namespace isocast::inline ISO_ISA
