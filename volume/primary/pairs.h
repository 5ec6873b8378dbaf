// Pairs of a ray and a cell, solved sixteen at a time whatever ray and cell they come from.
#pragma once

#include <isocast/math/pack.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/primary/kernels.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/solve_packet.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

inline PairQueue<float>& pairs_of(PatchState& patch, float) { return patch.pairs_float; }
inline PairQueue<double>& pairs_of(PatchState& patch, double) { return patch.pairs_double; }

/// The first pairs of the queue as cells to be solved.
template <class T> inline void load_pairs(const PairQueue<T>& queue, CellPacket<T>& packet) {
  for (int k = 0; k < 8; ++k)
    for (int l = 0; l < kPacketSize; ++l) packet.f[k][l] = queue.f[k][l];
  for (int a = 0; a < 3; ++a)
    for (int l = 0; l < kPacketSize; ++l) {
      packet.entry[a][l] = queue.entry[a][l];
      packet.exit[a][l] = queue.exit[a][l];
    }
  for (int l = 0; l < kPacketSize; ++l) {
    packet.begin[l] = packet.slack[l] = T(0);
    packet.carry[l] = T(__builtin_nan(""));
  }
  packet.active = (1u << (queue.size < kPacketSize ? queue.size : kPacketSize)) - 1;
}

/// The slack of the pairs' chords, for methods that prove.
template <class T>
inline void find_slack(const VolumeQuery& query, const PatchState& patch, const PairQueue<T>& queue,
                       CellPacket<T>& packet) {
  for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
    const int l = __builtin_ctz(rest), ray = int(queue.ray[l]), x = patch.x + ray % kPatchPitch,
              y = patch.y + ray / kPatchPitch;
    const auto [o, d] = primary_ray(patch.frame, x + patch.offset_u, y + patch.offset_v);
    packet.slack[l] =
        chord_slack<T>(ray_slack(query, {o.x, o.y, o.z}, {d.x, d.y, d.z}), queue.t_in[l], queue.t_out[l]);
  }
}

/// The queue without its first kPacketSize pairs: a window adds at most eight to one packet.
template <class T> inline void drop_pairs(PairQueue<T>& queue) {
  const auto move = [](auto& array) {
    for (int l = 0; l < 8; ++l) array[l] = array[l + kPacketSize];
  };
  for (auto& array : queue.f) move(array);
  for (int a = 0; a < 3; ++a) {
    move(queue.entry[a]);
    move(queue.exit[a]);
    move(queue.cell[a]);
  }
  move(queue.t_in);
  move(queue.t_out);
  move(queue.axis);
  move(queue.ray);
  move(queue.iso);
  queue.size = queue.size > kPacketSize ? queue.size - kPacketSize : 0;
  for (int l = 0; l < queue.size && queue.any_start; ++l)
    if (queue.axis[l] == kStart) return;
  queue.any_start = false;
}

/// Takes the root of pair l as its ray's hit if the walk would have met it before the one there is: cells are
/// ordered by (t_in, axis), roots in a cell by s, then by the number of the iso-value.
template <class T>
inline void take_root(const PairQueue<T>& queue, const RootPacket<T>& roots, int l, bool proves,
                      PatchState& patch) {
  const int ray = int(queue.ray[l]);
  const double t_in = queue.t_in[l], s = double(roots.s[l]);
  const std::uint8_t axis = std::uint8_t(queue.axis[l]);
  PatchHit& hit = patch.hits[ray];
  if (t_in > patch.depth[ray] || (t_in == patch.depth[ray] && axis > patch.axis[ray])) return;
  if (t_in == patch.depth[ray] && axis == patch.axis[ray]) {
    // two iso-values in one cell
    if (proves && double(roots.s_lo[l]) < hit.s_hi && hit.s_lo < double(roots.s_hi[l])) patch.walk[ray] = 1;
    if (s > hit.s || (s == hit.s && queue.iso[l] > hit.iso)) return;
  }
  patch.depth[ray] = t_in;
  patch.axis[ray] = axis;
  hit = {queue.t_out[l],
         s,
         double(roots.s_lo[l]),
         double(roots.s_hi[l]),
         {queue.cell[0][l], queue.cell[1][l], queue.cell[2][l]},
         std::uint8_t(queue.iso[l]),
         bool(roots.undecided >> l & 1),
         bool(roots.sign >> l & 1)};
  const int x = ray % kPatchPitch, y = ray / kPatchPitch;
  patch.stale |= std::uint64_t(1) << (y / kPartSize * kPatchParts + x / kPartSize);
}

/// Solves the first pairs of the queue. A ray that starts on the surface is the walk's to answer, and so is
/// one on which a method that proves leaves a cell unproved.
template <class T> inline void solve_pairs(const VolumeQuery& query, PatchState& patch, TraceCounts& counts) {
  PairQueue<T>& queue = pairs_of(patch, T{});
  alignas(64) CellPacket<T> packet;
  alignas(64) RootPacket<T> roots;
  load_pairs(queue, packet);
  if (query.proves) find_slack(query, patch, queue, packet);
  solve_packet(query, packet, roots);
  counts.solves += __builtin_popcount(packet.active);
  if (queue.any_start)
    for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      if (queue.axis[l] != kStart) continue;
      T f[8];
      for (int k = 0; k < 8; ++k) f[k] = packet.f[k][l];
      const Vec3<T> entry = {packet.entry[0][l], packet.entry[1][l], packet.entry[2][l]};
      if (trilinear<T>(f, entry) == T(0)) patch.walk[int(queue.ray[l])] = 1;
    }
  if (query.proves)
    for (std::uint32_t rest = packet.active & ~roots.proved; rest; rest &= rest - 1)
      patch.walk[int(queue.ray[__builtin_ctz(rest)])] = 1;
  for (std::uint32_t rest = roots.hit; rest; rest &= rest - 1)
    take_root(queue, roots, __builtin_ctz(rest), query.proves, patch);
  drop_pairs(queue);
}

}  // namespace isocast::inline ISO_ISA
