// What shares of their pixels a surface covers.
#pragma once

#include <isocast/ray/primary_pass.h>

namespace isocast {

/// Shares of the pixels of a block of tiles, in View::fill's order, and hits for pixels whose own rays miss
/// what covers a part of them; large.
///
/// share   of the pixel's square: 0 where it is proved to be empty
/// open    as much of the pixel neither is proved empty nor proved to hold the surface; only told of pixels
/// that are
///         not wholly covered
/// spare   where the surface is on the pixel's ray, nearly, in tiles that it covers a part of
struct BlockCover {
  float share[kBlockStreams][kStreamSize], open[kBlockStreams][kStreamSize];
  BlockHits spare;
};

/// Made by Surface::coverage. Calls are const and may come from any thread.
class CoveragePass {
 public:
  virtual ~CoveragePass() = default;
  /// All of block (bx, by).
  virtual void cover(int bx, int by, BlockCover& cover, TraceCounts& counts) const = 0;
};

}  // namespace isocast
