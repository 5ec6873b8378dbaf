// Streams of rays through dense grids of every sample type.
#include <isocast/volume/dense_grid.h>
#include <isocast/volume/trace_sparse.h>
#include <isocast/volume/trace_stream.h>

namespace isocast {
namespace {

void trace(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  if (query.sparse) return trace_sparse(query, next, rays, hits, counts);
  visit_sample_type(query.grid.type, [&]<class S>(SampleTag<S>) {
    trace_grid<DenseGrid<S>>(query, next, rays, hits, counts);
  });
}

}  // namespace

void trace_first_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace(query, false, rays, hits, counts);
}
void trace_next_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  trace(query, true, rays, hits, counts);
}

}  // namespace isocast
