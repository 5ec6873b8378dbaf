// What mirroring surfaces show.
#pragma once

#include <isocast/render/shade.h>

namespace isocast {

/// The colours of hits with what they mirror: a stream of mirrored rays, then of those that these spawn, and
/// so on. Everything that they hit counts as opaque; where they hit nothing they see the environment or the
/// background.
class Reflections {
 public:
  /// Adds to colors[slot] of every hit of `wave` its weight times its colour.
  void color(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
             RenderCounts& counts);

 private:
  void trace(const Frame& frame, Wave& wave, RenderCounts& counts);

  Wave waves_[2];
  HitStream hits_[2];
};

}  // namespace isocast
