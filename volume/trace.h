// Sixteen rays at a time, or one: each walks to its next active cell, then all cells are solved together.
#pragma once

#include <isocast/volume/march.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/solve_cells.h>

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

  ISO_HD void leave_first_cell() {
    carried = false;
    begin = 0;
    iso_of_hit = -1;
  }
};

/// The cells of up to N lanes, as solve_cells.h asks for them.
template <class Grid, int N> class LaneCells {
 public:
  static constexpr int kLanes = N;

  ISO_HD LaneCells(const VolumeQuery& query, const Grid& grid, const Lane<Grid>* lanes)
      : query_(query), grid_(grid), lanes_(lanes) {}

  ISO_HD std::uint32_t holding(int iso, std::uint32_t lanes) const {
    std::uint32_t held = 0;
    for_lanes<N>(lanes, [&](int l) { held |= (lanes_[l].active >> iso & 1) << l; });
    return held;
  }
  template <class T>
  ISO_HD std::uint32_t fetch(int iso, std::uint32_t lanes, CellPacket<T, N>& packet,
                             std::uint32_t& doubtful) const {
    std::uint32_t fetched = 0;
    for_lanes<N>(lanes, [&](int l) {
      if (fetch_one(iso, packet, l)) fetched |= 1u << l;
      else if (query_.proves && has_finite_corners(lanes_[l])) doubtful |= 1u << l;
    });
    return fetched;
  }
  ISO_HD bool starts(int l) const { return lanes_[l].walk.axis_in == kStart && !lanes_[l].carried; }
  ISO_HD bool known_sides(int l, std::uint32_t& sides) const {
    sides = lanes_[l].sides;
    return lanes_[l].carried;
  }
  ISO_HD CellRoot place(int l) const {
    const GridWalk<Grid::kLevels>& walk = lanes_[l].walk;
    const std::int32_t(&cell)[3] = walk.cell();
    return {.t_in = walk.t_in, .t_out = walk.t_out(), .cell = {cell[0], cell[1], cell[2]}};
  }
  ISO_HD bool doubt(int l) const { return lanes_[l].doubt; }

 private:
  template <class T> ISO_HD bool fetch_one(int iso, CellPacket<T, N>& packet, int l) const {
    const Lane<Grid>& lane = lanes_[l];
    typename Grid::Sample raw[8];
    grid_.load_corners(lane.walk.cell(), lane.place, raw);
    T finite = 0;
    for (int k = 0; k < 8; ++k) {
      // what proves rounds the difference alone
      packet.f[k][l] = query_.proves ? T(corner_value<double>(raw[k], query_.iso[iso]))
                                     : corner_value<T>(raw[k], query_.iso[iso]);
      finite += packet.f[k][l] * T(0);
    }
    T entry[3], exit[3];
    point_in_cell(lane.ray, lane.walk, lane.walk.t_in, lane.walk.axis_in, false, entry);
    point_in_cell(lane.ray, lane.walk, lane.walk.t_out(), lane.walk.axis_out(), true, exit);
    for (int a = 0; a < 3; ++a) {
      packet.entry[a][l] = entry[a];
      packet.exit[a][l] = exit[a];
    }
    packet.slack[l] = query_.proves ? chord_slack<T>(lane.slack, lane.walk.t_in, lane.walk.t_out()) : T(0);
    set_start(packet, l, iso == lane.iso_of_hit ? lane.begin_of_iso : lane.begin, lane.carried, lane.sides,
              iso);
    return finite == T(0);
  }

  // Whether the lane's cell exists, though its corners minus iso may be too large.
  ISO_HD bool has_finite_corners(const Lane<Grid>& lane) const {
    typename Grid::Sample raw[8];
    grid_.load_corners(lane.walk.cell(), lane.place, raw);
    double finite = 0;
    for (const auto& sample : raw) finite += double(number(sample)) * 0.0;
    return finite == 0;
  }

  const VolumeQuery& query_;
  const Grid& grid_;
  const Lane<Grid>* lanes_;
};

/// Traces the lanes of `alive` to their first root, or the end; `slot` is lane 0's place in the streams.
template <int N, class T, class Grid>
ISO_HD inline void trace_packet(const VolumeQuery& query, const Grid& grid, Lane<Grid>* lanes,
                                std::uint32_t alive, const RayStream& rays, HitStream& hits, int slot,
                                TraceCounts& counts) {
  CellPacket<T, N> packet = {};
  RootPacket<T, N> roots = {};
  std::uint32_t cost[N] = {};
  const LaneCells<Grid, N> cells(query, grid, lanes);
  const std::uint32_t all = alive;
  bool tested = false;
  for (; alive; tested = true) {
    // every ray to its next active cell
    for_lanes<N>(alive, [&](int l) {
      Lane<Grid>& lane = lanes[l];
      const std::int64_t before = counts.cells;
      lane.active = march(grid, lane.ray, lane.walk, lane.place, tested, counts);
      if (lane.walk.moved) lane.leave_first_cell();
      cost[l] += std::uint32_t(counts.cells - before);
      if (!lane.active) alive &= ~(1u << l);
    });
    if (!alive) break;
    const Nearest<T, N> nearest = solve_cells(query, cells, alive, cost, packet, roots, counts);
    for_lanes<N>(nearest.unproved, [&](int l) { lanes[l].doubt = true; });
    for_lanes<N>(nearest.hit, [&](int l) { record_hit(query, cells, nearest, l, rays, hits, slot + l); });
    alive &= ~nearest.hit;
  }
  for_lanes<N>(all, [&](int l) {
    hits.cost[slot + l] += cost[l];
    if (query.proves && lanes[l].doubt) hits.certificate[slot + l] = Certificate::undecided;
  });
}

}  // namespace isocast::inline ISO_ISA
