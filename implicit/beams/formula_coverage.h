// How much of each pixel a formula's surfaces cover.
#pragma once

#include <isocast/implicit/beams/block_pass.h>
#include <isocast/ray/coverage_pass.h>

namespace isocast {

/// An adaptive quadtree of affine beams, down to sixteenths of pixels, in which depths are halved until they
/// are as long as the sixteenth is wide: a sixteenth that is not thrown away is covered. So what is thinner
/// than a pixel does not vanish. It is proved to be covered where f has one sign on all of the beam's
/// cross-section before what could not be thrown away, the other one on one behind, and is continuous
/// between.
///
/// source  Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic,
///         SIBGRAPI 2011, for the quadtree; the proof is ours
template <class T> class FormulaCoverage final : public CoveragePass, private BlockPass<T> {
 public:
  using BlockPass<T>::BlockPass;
  void cover(int bx, int by, BlockCover& cover, TraceCounts& counts) const override;
};

}  // namespace isocast
