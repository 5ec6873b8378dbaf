// The method `certified` for formulas: the primary rays of a picture by trees of beams.
#pragma once

#include <isocast/implicit/beams/block_pass.h>
#include <isocast/implicit/expression/prune.h>

namespace isocast {

/// Hits are proved by beams where they can be; rays that those leave open are solved by the surface's
/// first_hit, each for itself, from where they were left.
///
/// proofs  as ImplicitSurface's
template <class T> class CertifiedPass final : public BlockPass<T> {
 public:
  using BlockPass<T>::BlockPass;
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  void trace(const BlockRays<T>& rays, BlockRoots<T>& roots) const;
  void trace_pruned(const BlockRays<T>& rays, BlockRoots<T>& roots) const;
  const Tape& pruned(const Tape& tape, const BlockRays<T>& rays, int x, int y, int size, DepthRange<T> part,
                     Pruner<T>& pruner) const;
  void solve_open_rays(int bx, int by, double offset_u, double offset_v, const BlockRays<T>& rays,
                       const BlockRoots<T>& roots, BlockHits& hits, TraceCounts& counts) const;
};

}  // namespace isocast
