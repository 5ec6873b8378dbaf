// The primary rays of certified on a device: first beams, then rays from where those left off.
#pragma once

#include <isocast/implicit/beams/beam_caster.h>
#include <isocast/implicit/beams/block_pass.h>
#include <isocast/render/stream_pass.h>

namespace isocast {

/// A quadtree of beams down to pixels, in which depths are halved until they are as long as four pixels are
/// wide. A ray whose pixel was thrown away is proved to miss; others are solved from the depth before which
/// their pixel is empty, a block's together.
///
/// caster  of beams, for as long as the pass lives; trace: of rays
/// source  Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic,
///         SIBGRAPI 2011, for the quadtree
template <class T> class BeamedRaysPass final : public PrimaryPass, private BlockPass<T> {
 public:
  BeamedRaysPass(const View& view, const FormulaQuery<T>& query, const FormulaPassInputs& inputs,
                 const BeamCaster& caster, TraceStreams trace)
      : BlockPass<T>(view, query, inputs), caster_(caster), trace_(std::move(trace)) {}
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  const BeamCaster& caster_;
  TraceStreams trace_;
};

}  // namespace isocast
