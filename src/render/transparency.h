// The colours of primary rays, through the layers that they pass.
#pragma once

#include <isocast/render/reflections.h>

namespace isocast {

/// What one thread needs for a tile: large.
///
/// candidates  numbers of the objects that the tile may meet
/// hits        of the primary rays, where no pass keeps them
struct TileBuffers {
  std::vector<std::uint16_t> candidates;
  Wave primary;
  HitStream hits;
  Crossings crossings;
  Reflections reflections;
  Shadows shadows;
};

/// Finds the first hits of a tile's primary rays with the candidates.
///
/// found  what the passes found, which is used further; null where they found nothing or there are none
void trace_first_hits(const Frame& frame, HitStream* found, TileBuffers& b, TraceCounts& counts);

/// Position, normal and value of the hits, as wished.
void dress_hits(const Frame& frame, const DressWishes& wishes, TileBuffers& b);

/// Adds a sample's share of colour to every pixel of the tile, front to back from the dressed first hits on.
///
/// Each layer adds T a c and leaves T (1 - a), where T is what came through before, a its opacity and c its
/// colour; what is left at the end is the environment's or the background's. The last layer that
/// settings.transparency_depth admits counts as opaque if another follows, unless its opacity is 0. The hits
/// are used up.
///
/// source  Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces
///         with interval and affine arithmetic, Computer Graphics Forum 28(1), 2009
void add_colors(const Frame& frame, TileBuffers& b, Film& film, RenderCounts& counts);

}  // namespace isocast
