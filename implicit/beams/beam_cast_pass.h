// The methods beam-uniform and beam-adaptive.
#pragma once

#include <isocast/implicit/beams/beam_caster.h>
#include <isocast/implicit/beams/block_pass.h>

namespace isocast {

/// eps       of a pixel, in depth from -1 to 1 between the planes that hold the domain
/// finer     levels below pixels
/// adaptive  a quadtree over each block; else every pixel for itself
/// affine    affine forms, else intervals
struct BeamCastOptions {
  double eps;
  int finer;
  bool adaptive, affine;
};

/// Pixels, not rays: a pixel is proved to miss where its beam, as wide as the pixel, holds no root; what
/// cannot be thrown away is a hit, undecided, in the middle of the depths that are left. `cost` is the level
/// at which the last of a pixel's beams was thrown away.
template <class T> class BeamCastPass final : public PrimaryPass, private BlockPass<T> {
 public:
  /// caster  made for the options' form, or null: this processor; for as long as the pass lives
  BeamCastPass(const View& view, const FormulaQuery<T>& query, const FormulaPassInputs& inputs,
               const BeamCastOptions& options, const BeamCaster* caster)
      : BlockPass<T>(view, query, inputs), options_(options), caster_(caster) {}
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  void cast(const BlockRays<T>& rays, BlockRoots<T>& roots, BlockCells<T>& cells) const;

  BeamCastOptions options_;
  const BeamCaster* caster_;
};

}  // namespace isocast
