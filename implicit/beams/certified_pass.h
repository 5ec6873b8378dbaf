// The method `certified` for formulas: the primary rays of a picture by trees of beams.
#pragma once

#include <isocast/implicit/beams/block_pass.h>

namespace isocast {

/// Hits are proved by beams where they can be; rays that those leave open are solved by the surface's
/// first_hit, each for itself, from where they were left.
///
/// proofs  as ImplicitSurface's
template <class T> class CertifiedPass final : public PrimaryPass, private BlockPass<T> {
 public:
  using BlockPass<T>::BlockPass;
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  void solve_open_rays(int bx, int by, double offset_u, double offset_v, const BlockRays<T>& rays,
                       const BlockRoots<T>& roots, BlockHits& hits, TraceCounts& counts) const;
};

}  // namespace isocast
