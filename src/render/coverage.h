// Pixels that a surface covers a part of, blended with what lies behind.
#pragma once

#include <isocast/ray/coverage_pass.h>
#include <isocast/render/frame.h>

namespace isocast {

/// A tile of a BlockCover. spare: null where nothing is covered.
struct TileCover {
  const float *share, *open;
  const HitStream* spare;
};

/// Gives a hit to those rays of a tile that hit nothing in pixels of which something is covered. True if
/// there are any.
bool take_spares(const TileCover& cover, Wave& wave);

/// Of the tile's colours, which are those of the pixels' middles, each pixel keeps the share that is covered;
/// the rest is background. Counts the pixels of which a part is covered, and those of them where that is open
/// in part.
void blend_cover(const Frame& frame, const TileCover& cover, const RayStream& rays, Film& film,
                 RenderCounts& counts);

}  // namespace isocast
