// Streams of rays through one kind of grid: rays are taken to grid space and traced sixteen at a time.
#pragma once

#include <isocast/volume/solve_packet.h>
#include <isocast/volume/trace.h>

namespace isocast::inline ISO_ISA {

/// The ray of a slot in grid space.
ISO_HD inline GridRay grid_ray(const VolumeQuery& query, const RayStream& rays, int i) {
  const double(&m)[3][4] = query.grid_from_world;
  double o[3], d[3];
  for (int a = 0; a < 3; ++a) {
    o[a] = m[a][0] * rays.ox[i] + m[a][1] * rays.oy[i] + m[a][2] * rays.oz[i] + m[a][3];
    d[a] = m[a][0] * rays.dx[i] + m[a][1] * rays.dy[i] + m[a][2] * rays.dz[i];
  }
  return make_grid_ray(o, d, query.samples);
}

ISO_HD inline RaySlack ray_slack(const VolumeQuery& query, const RayStream& rays, int i) {
  return ray_slack(query, {rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]});
}

/// A fresh ray, or one that starts on this surface and knows its sides; false if it misses the grid.
template <class Grid>
ISO_HD inline bool start(const VolumeQuery& query, const Grid& grid, const RayStream& rays,
                         const HitStream& hits, int i, Lane<Grid>& lane) {
  lane.ray = grid_ray(query, rays, i);
  if (query.proves) lane.slack = ray_slack(query, rays, i);
  lane.carried = rays.start_object[i] == query.object;
  lane.sides = rays.start_sides[i];
  return enter_grid(lane.ray, grid.shifts, query.active, rays.t_min[i], min(hits.t[i], rays.t_max[i]),
                    lane.walk);
}

/// A ray behind its hit, which is cleared; false if it has none here.
template <class Grid>
ISO_HD inline bool resume(const VolumeQuery& query, const Grid& grid, const RayStream& rays, HitStream& hits,
                          int i, Lane<Grid>& lane) {
  if (hits.object[i] != query.object || !(hits.t[i] < __builtin_inf())) return false;
  hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = __builtin_inf();
  lane.ray = grid_ray(query, rays, i);
  if (query.proves) lane.slack = ray_slack(query, rays, i);
  lane.carried = true;
  lane.sides = sides_behind(hits, i);
  lane.begin = hits.s[i];
  lane.begin_of_iso = hits.s_hi[i];
  lane.iso_of_hit = hits.iso[i];
  if (!enter_grid(lane.ray, grid.shifts, query.active, rays.t_min[i], rays.t_max[i], lane.walk)) return false;
  const std::int32_t cell[3] = {hits.cell[0][i], hits.cell[1][i], hits.cell[2][i]};
  resume_in_cell(lane.ray, grid.shifts, cell, rays.t_min[i], lane.walk);
  return true;
}

/// First hits of N rays from `slot` on, or the next ones behind those that `hits` holds.
template <int N, class T, class Grid>
ISO_HD inline void trace_slots(const VolumeQuery& query, const Grid& grid, bool next, const RayStream& rays,
                               HitStream& hits, int slot, TraceCounts& counts) {
  Lane<Grid> lanes[N];
  const int left = rays.size - slot;
  std::uint32_t alive = 0;
  for_lanes<N>(left < N ? (1u << left) - 1 : (1u << N) - 1, [&](int l) {
    alive |= std::uint32_t(next ? resume(query, grid, rays, hits, slot + l, lanes[l])
                                : start(query, grid, rays, hits, slot + l, lanes[l]))
             << l;
  });
  if (alive) trace_packet<N, T>(query, grid, lanes, alive, rays, hits, slot, counts);
}

/// All rays of a stream.
template <class T, class Grid>
void trace_stream(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits,
                  TraceCounts& counts) {
  const Grid grid(query);
  for (int slot = 0; slot < rays.size; slot += kPacketSize)
    trace_slots<kPacketSize, T>(query, grid, next, rays, hits, slot, counts);
}

/// The same in the precision of the query.
template <class Grid>
void trace_grid(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits,
                TraceCounts& counts) {
  if (query.double_precision) trace_stream<double, Grid>(query, next, rays, hits, counts);
  else trace_stream<float, Grid>(query, next, rays, hits, counts);
}

}  // namespace isocast::inline ISO_ISA
