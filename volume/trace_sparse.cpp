// Streams of rays through sparse grids of every sample type.
#include <isocast/volume/sparse_grid.h>
#include <isocast/volume/trace_sparse.h>
#include <isocast/volume/trace_stream.h>

namespace isocast {

void trace_sparse(const VolumeQuery& query, bool next, const RayStream& rays, HitStream& hits,
                  TraceCounts& counts) {
  visit_sparse_type(query.tree.type, [&]<class S>(SparseTag<S>) {
    trace_grid<SparseGrid<S>>(query, next, rays, hits, counts);
  });
}

}  // namespace isocast
