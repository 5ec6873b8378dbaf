// What casts the beams of a formula in place of this processor's kernels.
#pragma once

#include <isocast/implicit/solve/segment.h>

namespace isocast {

template <class T> struct BlockRays;
template <class T> struct BlockRoots;

/// What a caster is made for. affine: affine forms, else intervals
struct BeamCastKey {
  bool affine, double_precision;
  int iso_count;
  friend bool operator==(const BeamCastKey&, const BeamCastKey&) = default;
};

/// BlockKernels' cast, and guess for all tiles, of a block: the same bits where f is made of basic
/// arithmetic. Calls are const and may come from any thread.
class BeamCaster {
 public:
  virtual ~BeamCaster() = default;
  /// levels  of the block's pixels, as BlockCells::level
  virtual void cast(const FormulaQuery<float>& query, const BlockRays<float>& rays, int finer, bool adaptive,
                    BlockRoots<float>& roots, std::uint8_t* levels) const = 0;
  virtual void cast(const FormulaQuery<double>& query, const BlockRays<double>& rays, int finer,
                    bool adaptive, BlockRoots<double>& roots, std::uint8_t* levels) const = 0;
};

}  // namespace isocast
