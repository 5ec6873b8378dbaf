// Edges of surfaces between the middles of pixels, blended in.
#pragma once

#include <isocast/render/frame.h>

namespace isocast {

/// What a pixel's first sample hits: depth along the view axis, +inf for nothing; unit normal.
struct PixelHit {
  float depth = std::numeric_limits<float>::infinity();
  float normal[3] = {};
  std::uint16_t object = kNoObject;
  std::uint8_t iso = 0;
};

/// Keeps the hits of a tile; by pixel number.
void keep_hits(const Frame& frame, const Wave& wave, std::vector<PixelHit>& pixels);

/// Where a surface ends between the middles of two pixels, each takes the share of the other's colour that
/// its square needs. Of several neighbours the one counts that lies most in the direction of the surface's
/// normal on the screen. Colours alone; the number of pixels that were blended.
///
/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
/// 27(2),
///         2008, for the edges. Its blend, Wu's, gives the further pixel the whole covered way between the
///         middles, which makes surfaces half a pixel fatter
std::int64_t blend_silhouettes(const Frame& frame, const std::vector<PixelHit>& pixels, Film& film);

}  // namespace isocast
