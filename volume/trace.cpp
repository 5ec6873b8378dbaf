// Streams of rays through dense grids of every sample type.
#include <isocast/volume/trace_sparse.h>
#include <isocast/volume/trace_stream.h>
#include <isocast/volume/visit_grid.h>

namespace isocast {
namespace {

void trace(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  if (query.sparse) return trace_sparse(query, next, rays, hits, counts);
  visit_sample_type(query.grid.type, [&]<class S>(SampleTag<S>) {
    trace_grid<DenseGrid<S>>(query, next, rays, hits, counts);
  });
}

template <class T, class Grid>
std::uint32_t sides(const VolumeQuery& query, const RayStream& rays, int slot, const std::int32_t (&cell)[3],
                    int iso, bool behind, bool touched) {
  const Grid grid(query);
  Lane<Grid> lane;
  lane.ray = grid_ray(query, rays, slot);
  resume_in_cell(lane.ray, grid.shifts, cell, rays.t_min[slot], lane.walk);
  grid.enter(cell, lane.place);
  lane.active = ~0u;  // which iso-values the cell holds is not known
  return sides_in_front<T>(query, LaneCells<Grid, 1>(query, grid, &lane), 0, iso, behind, touched);
}

}  // namespace

void trace_first_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace(query, false, rays, hits, counts);
}
void trace_next_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace(query, true, rays, hits, counts);
}

std::uint32_t sides_of_root(const VolumeQuery& query, const RayStream& rays, int slot,
                            const std::int32_t (&cell)[3], int iso, bool behind, bool touched) {
  if (query.iso_count == 1) return std::uint32_t(behind == touched) << iso;
  return visit_grid(query, [&]<class Grid>(GridTag<Grid>) {
    return query.double_precision ? sides<double, Grid>(query, rays, slot, cell, iso, behind, touched)
                                  : sides<float, Grid>(query, rays, slot, cell, iso, behind, touched);
  });
}

}  // namespace isocast
