// Sixteen rays at a time: each walks to its next active cell, then all cells are solved together.
#pragma once

#include <isocast/volume/cell/cell.h>
#include <isocast/volume/cell_root.h>
#include <isocast/volume/march.h>
#include <isocast/volume/query.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/solve_packet.h>

namespace isocast::inline ISO_ISA {

/// What a lane carries from cell to cell. Only in its first cell may the signs at the start be known (bits of
/// `sides`, f is then not evaluated there): where the ray starts on this very surface, or goes on behind a
/// hit. There roots are sought behind `begin`, and behind `begin_of_iso` for the iso-value that was hit. Of
/// methods that prove: `doubt` if something before this cell was not proved.
template <class Grid> struct Lane {
  GridRay ray;
  GridWalk<Grid::kLevels> walk;
  typename Grid::Place place;
  std::uint32_t active = 0, sides = 0;
  double begin = 0, begin_of_iso = 0;
  int iso_of_hit = -1;
  bool carried = false, doubt = false;
  RaySlack slack = {};

  void leave_first_cell() {
    carried = false;
    begin = 0;
    iso_of_hit = -1;
  }
};

/// Corners minus iso, chord and starting point of one lane's cell for one iso-value; false when a corner is
/// not finite.
template <class T, class Grid>
inline bool fetch_cell(const VolumeQuery& query, const Grid& grid, const Lane<Grid>& lane, int iso_index,
                       CellPacket<T>& packet, int l) {
  typename Grid::Sample raw[8];
  grid.load_corners(lane.walk.cell(), lane.place, raw);
  T finite = 0;
  for (int k = 0; k < 8; ++k) {
    // what proves rounds the difference alone
    packet.f[k][l] = query.proves ? T(corner_value<double>(raw[k], query.iso[iso_index]))
                                  : corner_value<T>(raw[k], query.iso[iso_index]);
    finite += packet.f[k][l] * T(0);
  }
  const LevelWalk& cell = lane.walk.level[lane.walk.kCells];
  const int out = cell.axis_out();
  T entry[3], exit[3];
  point_in_cell(lane.ray, lane.walk, lane.walk.t_in, lane.walk.axis_in, false, entry);
  point_in_cell(lane.ray, lane.walk, cell.t_next[out], out, true, exit);
  for (int a = 0; a < 3; ++a) {
    packet.entry[a][l] = entry[a];
    packet.exit[a][l] = exit[a];
  }
  packet.slack[l] = query.proves ? chord_slack<T>(lane.slack, lane.walk.t_in, lane.walk.t_out()) : T(0);
  packet.begin[l] = T(iso_index == lane.iso_of_hit ? lane.begin_of_iso : lane.begin);
  packet.carry[l] = lane.carried ? (lane.sides >> iso_index & 1 ? T(-0.0) : T(0)) : T(__builtin_nan(""));
  return finite == T(0);
}

/// Whether the lane's cell exists, though its corners minus iso may be too large for T.
template <class Grid> inline bool has_finite_corners(const Grid& grid, const Lane<Grid>& lane) {
  typename Grid::Sample raw[8];
  grid.load_corners(lane.walk.cell(), lane.place, raw);
  double finite = 0;
  for (const auto& sample : raw) finite += double(number(sample)) * 0.0;
  return finite == 0;
}

/// f at the entry of the lane's cell, as the intersectors see it.
template <class T> inline T value_at_entry(const CellPacket<T>& packet, int l) {
  T f[8];
  for (int k = 0; k < 8; ++k) f[k] = packet.f[k][l];
  return trilinear<T>(f, Vec3<T>{packet.entry[0][l], packet.entry[1][l], packet.entry[2][l]});
}

/// Sides of all iso-values in front of the hit of iso `hit_iso`; `behind`: f is negative behind it,
/// `touched`: so it is in front.
template <class T, class Grid>
inline std::uint32_t sides_in_front(const VolumeQuery& query, const Grid& grid, const Lane<Grid>& lane,
                                    int hit_iso, bool behind, bool touched) {
  std::uint32_t sides = std::uint32_t(behind == touched) << hit_iso;
  CellPacket<T> cell;
  for (int i = 0; i < query.iso_count; ++i) {
    if (i == hit_iso) continue;
    if (lane.carried) sides |= lane.sides & 1u << i;
    else if (fetch_cell(query, grid, lane, i, cell, 0))
      sides |= std::uint32_t(negative(value_at_entry(cell, 0))) << i;
  }
  return sides;
}

/// The nearest root among the iso-values in each lane's cell. unproved: that it is this one, or that there is
/// none.
template <class T> struct Nearest {
  T s[kPacketSize], s_lo[kPacketSize], s_hi[kPacketSize];
  int iso[kPacketSize];
  std::uint32_t hit = 0, undecided = 0, behind = 0, unproved = 0;
};
template <class T, class Grid>
inline Nearest<T> solve_cells(const VolumeQuery& query, const Grid& grid, const Lane<Grid>* lanes,
                              std::uint32_t alive, std::uint32_t* cost, CellPacket<T>& packet,
                              RootPacket<T>& roots, TraceCounts& counts) {
  Nearest<T> nearest;
  for (int i = 0; i < query.iso_count; ++i) {
    packet.active = 0;
    for (std::uint32_t rest = alive; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      if (!(lanes[l].active >> i & 1)) continue;
      if (!fetch_cell(query, grid, lanes[l], i, packet, l)) {
        if (query.proves && has_finite_corners(grid, lanes[l])) nearest.unproved |= 1u << l;
        continue;
      }
      packet.active |= 1u << l;
      ++cost[l];
      ++counts.solves;
    }
    if (packet.active == 0) continue;
    solve_packet(query, packet, roots);
    nearest.unproved |= packet.active & ~roots.proved;

    // exactly zero at the very start of a ray is a hit there; the side behind is the positive one
    for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      if (lanes[l].walk.axis_in != kStart || lanes[l].carried || value_at_entry(packet, l) != T(0)) continue;
      roots.s[l] = roots.s_lo[l] = roots.s_hi[l] = T(0);
      roots.hit |= 1u << l;
      roots.undecided |= 1u << l;
      roots.sign &= ~(1u << l);
    }
    for (std::uint32_t rest = roots.hit; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      const std::uint32_t bit = 1u << l;
      if ((nearest.hit & bit) && roots.s_lo[l] < nearest.s_hi[l] && nearest.s_lo[l] < roots.s_hi[l])
        nearest.unproved |= bit;
      if ((nearest.hit & bit) && !(roots.s[l] < nearest.s[l])) continue;
      nearest.s[l] = roots.s[l];
      nearest.s_lo[l] = roots.s_lo[l];
      nearest.s_hi[l] = roots.s_hi[l];
      nearest.iso[l] = i;
      nearest.hit |= bit;
      nearest.undecided = (nearest.undecided & ~bit) | (roots.undecided & bit);
      nearest.behind = (nearest.behind & ~bit) | (roots.sign & bit);
    }
  }
  return nearest;
}

/// Writes the root of lane l into the hit of slot i, unless it lies behind the ray's end or a nearer hit.
template <class T, class Grid>
inline void record_hit(const VolumeQuery& query, const Grid& grid, const Lane<Grid>& lane,
                       const Nearest<T>& nearest, int l, const RayStream& rays, HitStream& hits, int i) {
  const std::int32_t(&cell)[3] = lane.walk.cell();
  const CellRoot root = {
      lane.walk.t_in,          lane.walk.t_out(),
      double(nearest.s[l]),    double(nearest.s_lo[l]),
      double(nearest.s_hi[l]), {cell[0], cell[1], cell[2]},
      nearest.iso[l],          (nearest.undecided >> l & 1) || (query.proves && lane.doubt)};
  if (is_nearer(root, rays, hits, i))
    write_hit(query, root,
              sides_in_front<T>(query, grid, lane, root.iso, nearest.behind >> l & 1, root.undecided), hits,
              i);
}

/// Traces the lanes of `alive` to their first root, or the end; `slot` is lane 0's place in the streams.
template <class T, class Grid>
inline void trace_packet(const VolumeQuery& query, const Grid& grid, Lane<Grid>* lanes, std::uint32_t alive,
                         const RayStream& rays, HitStream& hits, int slot, TraceCounts& counts) {
  alignas(64) CellPacket<T> packet = {};
  alignas(64) RootPacket<T> roots = {};
  std::uint32_t cost[kPacketSize] = {};
  const std::uint32_t all = alive;
  bool tested = false;
  for (; alive; tested = true) {
    // every ray to its next active cell
    for (std::uint32_t rest = alive; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      Lane<Grid>& lane = lanes[l];
      const std::int64_t before = counts.cells;
      lane.active = march(grid, lane.ray, lane.walk, lane.place, tested, counts);
      if (lane.walk.moved) lane.leave_first_cell();
      cost[l] += std::uint32_t(counts.cells - before);
      if (!lane.active) alive &= ~(1u << l);
    }
    if (!alive) break;
    const Nearest<T> nearest = solve_cells(query, grid, lanes, alive, cost, packet, roots, counts);
    for (std::uint32_t rest = nearest.unproved; rest; rest &= rest - 1)
      lanes[__builtin_ctz(rest)].doubt = true;

    for (std::uint32_t rest = nearest.hit; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      record_hit(query, grid, lanes[l], nearest, l, rays, hits, slot + l);
    }
    alive &= ~nearest.hit;
  }
  for (std::uint32_t rest = all; rest; rest &= rest - 1) {
    const int l = __builtin_ctz(rest);
    hits.cost[slot + l] += cost[l];
    if (query.proves && lanes[l].doubt) hits.certificate[slot + l] = Certificate::undecided;
  }
}

}  // namespace isocast::inline ISO_ISA
