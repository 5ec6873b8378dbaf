// Pairs of a ray and a cell, solved sixteen at a time whatever ray and cell they come from.
#pragma once

#include <isocast/volume/cell/cell.h>
#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/primary/chords.h>
#include <isocast/volume/primary/kernels.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/solve_packet.h>

namespace isocast::inline ISO_ISA {

inline CellRing<float>& cells_of(PatchState& patch, float) { return patch.cells_float; }
inline CellRing<double>& cells_of(PatchState& patch, double) { return patch.cells_double; }

/// Fetches a cell into a slot of its own; -1 where there is none.
template <class T>
inline int keep_cell(const VolumeQuery& query, const std::int32_t (&at)[3], int iso, CellRing<T>& ring) {
  static_assert(CellRing<T>::kSlots == kPacketSize);
  const int slot = int(ring.next % CellRing<T>::kSlots);
  for (int a = 0; a < 3; ++a) ring.at[a][slot] = at[a];
  const FetchedLanes fetched =
      fetch_cells(query, iso, {ring.at[0], ring.at[1], ring.at[2]}, 1u << slot, ring.f);
  if ((fetched.exists | fetched.doubtful) == 0) return -1;
  ++ring.next;
  ring.iso[slot] = iso;
  ring.doubtful[slot] = fetched.doubtful != 0;
  return slot;
}

/// Sixteen numbers, one for each slot of a ring, in the order of a packet's pairs.
template <class V>
inline void pick(const V (&slots)[kPacketSize], const std::int32_t* slot, V (&packet)[kPacketSize]) {
#ifdef __AVX512DQ__
  if constexpr (sizeof(V) == 4) {
    const __m512i picked =
        _mm512_maskz_permutexvar_epi32(0xffff, _mm512_loadu_si512(slot), _mm512_loadu_si512(slots));
    _mm512_storeu_si512(packet, picked);
    return;
  }
#endif
  for (int l = 0; l < kPacketSize; ++l) packet[l] = slots[slot[l]];
}

/// What the walk knows of the cells of a packet: where the rays enter and leave them. axis: that of the
/// entry, or kStart; start: some do.
struct alignas(64) PairChords {
  double t_in[kPacketSize], t_out[kPacketSize], axis[kPacketSize];
  bool start;
};

/// The first pairs of the queue as cells to be solved: those whose ray truly crosses the cell, before its
/// nearest root.
template <class T, bool kOrthographic>
inline void load_pairs(PatchState& patch, CellPacket<T>& packet, PairChords& chords) {
  using R = Native<double>;
  const PairQueue& queue = patch.queue;
  const CellRing<T>& ring = cells_of(patch, T{});
  const auto leave = [&](const std::int32_t* ray, unsigned rest) {
    for (; rest; rest &= rest - 1) leave_to_walk(patch, ray[__builtin_ctz(rest)]);
  };
  const unsigned waiting = (1u << (queue.size < kPacketSize ? queue.size : kPacketSize)) - 1;
  packet.active = 0;
  chords.start = false;
  std::int32_t cells[3][kPacketSize];
  for (int a = 0; a < 3; ++a) pick(ring.at[a], queue.cell, cells[a]);
  int i = 0;
  for (; i < kPacketSize && waiting >> i != 0; i += kWidth<R>) {
    const std::int32_t* ray = queue.ray + i;
    const R cell[3] = {load_as<R>(cells[0] + i), load_as<R>(cells[1] + i), load_as<R>(cells[2] + i)};
    const RayColumns<R> rays = load_rays<R>(patch.rays, ray);
    const CellPlanes<R> planes = meet_planes<R, kOrthographic>(patch.look, rays, cell);
    unsigned bits = bits_of((planes.t_in <= planes.t_out) & (planes.t_in <= rays.depth)) & waiting >> i;
    const CrossingAxes<R> axis = crossing_axes(planes);
    // a ray that starts on a plane is in the cell in front, or, on the border of the active blocks, behind
    leave(ray, bits & bits_of(planes.start & (planes.t_out == R(0))));
    bits &= bits_of((planes.t_in < planes.t_out) | (axis.in <= axis.out));
    packet.active |= bits << i;
    chords.start = chords.start || any(planes.start);
    store(chords.t_in + i, planes.t_in);
    store(chords.t_out + i, planes.t_out);
    store(chords.axis + i, axis.in);
    for (int a = 0; a < 3; ++a) {
      const ChordEnds<R> ends = chord_ends<R, kOrthographic>(patch.look, rays, cell, a, planes, axis);
      store_as(packet.entry[a] + i, ends.entry);
      store_as(packet.exit[a] + i, ends.exit);
    }
  }
  for (; i < kPacketSize; i += kWidth<R>)  // no pairs
    for (int a = 0; a < 3; ++a) {
      store_as(packet.entry[a] + i, R(0));
      store_as(packet.exit[a] + i, R(0));
    }
  for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
    const int l = __builtin_ctz(rest);
    if (!ring.doubtful[queue.cell[l]]) continue;
    leave_to_walk(patch, queue.ray[l]);
    packet.active &= ~(1u << l);
  }
  for (int k = 0; k < 8; ++k) pick(ring.f[k], queue.cell, packet.f[k]);
  using F = Native<T>;
  for (i = 0; i < kPacketSize; i += kWidth<F>) {
    store(packet.begin + i, F(0));
    store(packet.slack + i, F(0));
    store(packet.carry + i, F(T(__builtin_nan(""))));
  }
}

/// The slack of the pairs' chords, for methods that prove.
template <class T>
inline void find_slack(const VolumeQuery& query, const PatchState& patch, const PairChords& chords,
                       CellPacket<T>& packet) {
  for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
    const int l = __builtin_ctz(rest), ray = patch.queue.ray[l], x = patch.x + ray % kPatchPitch,
              y = patch.y + ray / kPatchPitch;
    const auto [o, d] = primary_ray(patch.frame, x + patch.offset_u, y + patch.offset_v);
    packet.slack[l] =
        chord_slack<T>(ray_slack(query, {o.x, o.y, o.z}, {d.x, d.y, d.z}), chords.t_in[l], chords.t_out[l]);
  }
}

/// The queue without its first kPacketSize pairs.
inline void drop_pairs(PairQueue& queue) {
  for (auto* array : {queue.ray, queue.cell})
    for (int l = 0; l < kPacketSize; ++l) array[l] = array[l + kPacketSize];
  queue.size = queue.size > kPacketSize ? queue.size - kPacketSize : 0;
}

/// Takes the root of pair l as its ray's hit if the walk would have met it before the one there is: cells are
/// ordered by (t_in, axis), roots in a cell by s, then by the number of the iso-value.
template <class T>
inline void take_root(const PairChords& chords, const RootPacket<T>& roots, int l, bool proves,
                      PatchState& patch) {
  const int ray = patch.queue.ray[l], slot = patch.queue.cell[l];
  const CellRing<T>& ring = cells_of(patch, T{});
  const int iso = ring.iso[slot];
  const double t_in = chords.t_in[l], axis = chords.axis[l], s = double(roots.s[l]);
  const PatchRay& met = patch.rays[ray];
  PatchHit& hit = patch.hits[ray];
  if (t_in > met.depth || (t_in == met.depth && axis > met.axis)) return;
  if (t_in == met.depth && axis == met.axis) {
    // two iso-values in one cell
    if (proves && double(roots.s_lo[l]) < hit.s_hi && hit.s_lo < double(roots.s_hi[l]))
      leave_to_walk(patch, ray);
    if (s > hit.s || (s == hit.s && iso > hit.iso)) return;
  }
  set_depth(patch, ray, t_in);
  patch.rays[ray].axis = axis;
  hit = {t_in,
         chords.t_out[l],
         s,
         double(roots.s_lo[l]),
         double(roots.s_hi[l]),
         {ring.at[0][slot], ring.at[1][slot], ring.at[2][slot]},
         std::uint8_t(iso),
         bool(roots.undecided >> l & 1),
         bool(roots.sign >> l & 1)};
  const int x = ray % kPatchPitch, y = ray / kPatchPitch;
  patch.met[y] |= std::uint64_t(1) << x;
  patch.stale |= std::uint64_t(1) << (y / kPartSize * kPatchParts + x / kPartSize);
}

/// Solves the first pairs of the queue. A ray that starts on the surface is the walk's to answer, and so is
/// one on which a method that proves leaves a cell unproved.
template <class T, bool kOrthographic>
inline void solve_pairs(const VolumeQuery& query, PatchState& patch, TraceCounts& counts) {
  alignas(64) CellPacket<T> packet;
  alignas(64) RootPacket<T> roots;
  PairChords chords;
  const std::int32_t* ray = patch.queue.ray;
  load_pairs<T, kOrthographic>(patch, packet, chords);
  if (query.proves) find_slack(query, patch, chords, packet);
  solve_packet(query, packet, roots);
  counts.solves += __builtin_popcount(packet.active);
  if (chords.start)
    for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      if (chords.axis[l] != kStart) continue;
      T f[8];
      for (int k = 0; k < 8; ++k) f[k] = packet.f[k][l];
      const Vec3<T> entry = {packet.entry[0][l], packet.entry[1][l], packet.entry[2][l]};
      if (trilinear<T>(f, entry) == T(0)) leave_to_walk(patch, ray[l]);
    }
  if (query.proves)
    for (std::uint32_t rest = packet.active & ~roots.proved; rest; rest &= rest - 1)
      leave_to_walk(patch, ray[__builtin_ctz(rest)]);
  for (std::uint32_t rest = roots.hit; rest; rest &= rest - 1)
    take_root(chords, roots, __builtin_ctz(rest), query.proves, patch);
  drop_pairs(patch.queue);
}

}  // namespace isocast::inline ISO_ISA
