// What a kernel of beams is given.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/segment.h>

namespace isocast {

/// Levels that a block can have, from itself down to the finest cells.
inline constexpr int kMostCastLevels = 8 + kMostFiner;
static_assert(kBlockSide == 1 << 7);

/// What threads count together.
struct BeamCounters {
  std::int64_t evaluations;
  std::int32_t cells[kMostCastLevels + 1];  // of each level
};

/// begin: a thread for each of the finest cells of a block; cast: one for each cell that `level` may have;
/// end: one for each pixel.
enum class BeamStep : std::int32_t { begin, cast, end };

/// One step of casting the beams of a block.
///
/// level   of begin the first one, of end the finest
/// cells   of the even levels and of the odd ones, in any order; each list has room for all of the finest
/// parts   of the finest cells, pixel by pixel in slots: what was not thrown away; from is +inf where all was
/// levels  of pixels, as BlockCells::level
template <class T> struct BeamWork {
  FormulaQuery<T> query;
  BlockRays<T> rays;
  BeamStep step;
  CastLevel level;
  BeamCounters* counters;
  BeamCell<T>* cells[2];
  DepthRange<T>* parts;
  PixelRoots<T>* roots;
  std::uint8_t* levels;
};

}  // namespace isocast
