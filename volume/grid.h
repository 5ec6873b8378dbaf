// A view of samples and of their macrocells: plain pointers and numbers that kernels receive.
#pragma once

#include <isocast/isa/std.h>
#include <isocast/volume/sample_type.h>

namespace isocast {

/// One level of the min/max pyramid: blocks of 2^shift cells per axis. `ranges` holds {min, max} pairs in the
/// volume's sample type (f16 as float), over all samples of the block's cells; NaN is left out, min > max
/// where nothing is left.
struct MacroLevel {
  const void* ranges;
  std::int32_t dims[3];
  std::int32_t shift;
};
inline constexpr int kMacroLevels = 2;

/// Blocks lo...hi of the coarsest level, both ends included; empty where lo > hi.
struct BlockBox {
  std::int32_t lo[3], hi[3];
};

/// Samples first...last per axis, both included; there is a cell between each two.
struct SampleBox {
  std::int32_t first[3], last[3];
};

/// dims[0] varies fastest. There are dims - 1 cells per axis; cell c has its lowest corner at sample c.
struct GridView {
  const void* samples;
  std::int32_t dims[3];
  SampleType type;
  MacroLevel levels[kMacroLevels];  // coarse first
};

/// Largest number of samples along an axis: cell numbers fit in 31 bits with room to step outside.
inline constexpr std::int64_t kMaxDim = std::int64_t(1) << 30;

}  // namespace isocast
