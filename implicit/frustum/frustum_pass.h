// The primary rays of a picture by the frustum form, block by block.
#pragma once

#include <isocast/implicit/frustum/frustum_tracer.h>

namespace isocast {

class FrustumPass final : public PrimaryPass {
 public:
  /// Tiles on a side that one form is good for; 0 where the domain is seen so small that rays do better each
  /// for itself.
  [[nodiscard]] static int tiles_of_form(const PixelLines& lines, const Box& domain, int degree);

  /// tape, view  must outlive the pass; tiles_of_form is not 0
  FrustumPass(const Tape& tape, const Box& domain, const FrustumOptions& options, const View& view,
              const DoubtfulRays& doubtful = {});

  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  [[nodiscard]] FrustumQuery make_query(double offset_u, double offset_v) const;

  const Tape& tape_;
  Box domain_;
  FrustumOptions options_;
  const View& view_;
  DoubtfulRays doubtful_;
  PixelLines lines_;
  int tiles_;                      // on a side, with a form of their own
  double position_slack_, slack_;  // what roundings of a ray's points are, and do to f
};

}  // namespace isocast
