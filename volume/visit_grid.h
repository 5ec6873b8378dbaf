// The grid of a query as the type that answers the walk's questions.
#pragma once

#include <isocast/volume/dense_grid.h>
#include <isocast/volume/sparse_grid.h>

namespace isocast::inline ISO_ISA {

template <class Grid> struct GridTag { using Type = Grid; };
/// Calls visit(GridTag<Grid>{}) with Grid a DenseGrid or a SparseGrid of the samples' type.
template <class Visit> decltype(auto) visit_grid(const VolumeQuery& query, Visit&& visit) {
  if (query.sparse)
    return visit_sparse_type(query.tree.type, [&]<class S>(SparseTag<S>) -> decltype(auto) {
      return visit(GridTag<SparseGrid<S>>{});
    });
  return visit_sample_type(query.grid.type, [&]<class S>(SampleTag<S>) -> decltype(auto) {
    return visit(GridTag<DenseGrid<S>>{});
  });
}

}  // namespace isocast::inline ISO_ISA
