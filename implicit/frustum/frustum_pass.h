// The primary rays of a picture by the frustum form, block by block.
#pragma once

#include <isocast/implicit/frustum/degree_tables.h>
#include <isocast/implicit/frustum/frustum_tracer.h>

namespace isocast {

class FrustumPass final : public PrimaryPass {
 public:
  /// steepest  no gradient of f in the domain is longer
  FrustumPass(const Tape& tape, const Box& domain, const FrustumOptions& options, double steepest,
              const View& view);

  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  const Tape& tape_;
  Box domain_;
  FrustumOptions options_;
  double steepest_;
  PixelLines lines_;
  DegreeMatrices across_, along_;
};

}  // namespace isocast
