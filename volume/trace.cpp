// Streams of rays through grids of every sample type.
#include <isocast/volume/trace.h>

namespace isocast {
namespace {

// The ray of a slot in grid space.
GridRay grid_ray(const VolumeQuery& query, const RayStream& rays, int i) {
  const double(&m)[3][4] = query.grid_from_world;
  double o[3], d[3];
  for (int a = 0; a < 3; ++a) {
    o[a] = m[a][0] * rays.ox[i] + m[a][1] * rays.oy[i] + m[a][2] * rays.oz[i] + m[a][3];
    d[a] = m[a][0] * rays.dx[i] + m[a][1] * rays.dy[i] + m[a][2] * rays.dz[i];
  }
  return make_grid_ray(o, d, query.grid.dims);
}

// A fresh ray, or one that starts on this surface and knows its sides.
bool start(const VolumeQuery& query, const RayStream& rays, const HitStream& hits, int i, Lane& lane) {
  lane.ray = grid_ray(query, rays, i);
  lane.carried = rays.start_object[i] == query.object;
  lane.sides = rays.start_sides[i];
  return enter_grid(lane.ray, query.grid.levels[0].shift, query.active, rays.t_min[i],
                    min(hits.t[i], rays.t_max[i]), lane.walk);
}

// A ray behind its hit, which is cleared.
bool resume(const VolumeQuery& query, const RayStream& rays, HitStream& hits, int i, Lane& lane) {
  if (hits.object[i] != query.object || !(hits.t[i] < __builtin_inf())) return false;
  hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = __builtin_inf();
  lane.ray = grid_ray(query, rays, i);
  lane.carried = true;
  lane.sides = sides_behind(hits, i);
  lane.begin = hits.s[i];
  lane.begin_of_iso = hits.s_hi[i];
  lane.iso_of_hit = hits.iso[i];
  if (!enter_grid(lane.ray, query.grid.levels[0].shift, query.active, rays.t_min[i], rays.t_max[i],
                  lane.walk))
    return false;
  const std::int64_t row = query.grid.dims[0], slice = row * query.grid.dims[1], index = hits.cell[i];
  const std::int32_t cell[3] = {std::int32_t(index % row), std::int32_t(index % slice / row),
                                std::int32_t(index / slice)};
  resume_in_cell(lane.ray, Shifts(query.grid).of, cell, rays.t_min[i], lane.walk);
  return true;
}

template <class T, class S, auto set_up>
void trace_stream(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  const TypedGrid<S> grid(query);
  const Shifts shifts(query.grid);
  for (int slot = 0; slot < rays.size; slot += kPacketSize) {
    Lane lanes[kPacketSize];
    std::uint32_t alive = 0;
    for (int l = 0; l < kPacketSize && slot + l < rays.size; ++l)
      alive |= std::uint32_t(set_up(query, rays, hits, slot + l, lanes[l])) << l;
    if (alive) trace_packet<T>(query, grid, shifts, lanes, alive, rays, hits, slot, counts);
  }
}

template <auto set_up>
void trace(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  visit_sample_type(query.grid.type, [&](auto tag) {
    using S = typename decltype(tag)::Type;
    if (query.double_precision) trace_stream<double, S, set_up>(query, rays, hits, counts);
    else trace_stream<float, S, set_up>(query, rays, hits, counts);
  });
}

}  // namespace

void trace_first_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace<start>(query, rays, hits, counts);
}
void trace_next_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace<resume>(query, rays, hits, counts);
}

}  // namespace isocast
