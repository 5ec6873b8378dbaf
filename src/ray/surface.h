// What the renderer knows of a surface, whatever kind of f it has.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/coverage_pass.h>
#include <isocast/ray/edge_step.h>
#include <isocast/ray/hit.h>
#include <isocast/ray/pixel_lines.h>
#include <isocast/ray/stream.h>
#include <isocast/ray/tile.h>

#include <memory>
#include <span>

namespace isocast {

class View;

/// Normals from the gradient of what is solved, from central differences of it, or from the hits of
/// neighbouring pixels (neighbour_normals.h; the gradient where there are none).
enum class NormalKind : std::uint8_t { gradient, difference, neighbour };

/// What shading and layers may ask of a hit.
struct DressWishes {
  bool normal = false, position = false, value = false;
};

/// World-space position, unit normal (turned against the ray) and the value of the field in the user's units;
/// only what was wished is written. The normal is zero where the gradient vanishes.
struct alignas(64) DressedHits {
  double position[3][kStreamSize];
  double normal[3][kStreamSize];
  double value[kStreamSize];
};

/// Bit i of `below` set: f < iso i; `sure` if that is proved, or clear without a proof.
struct RaySides {
  std::uint32_t below;
  bool sure;
};

/// One object: a set of iso-values of one f. All calls are const and may come from any thread.
class Surface {
 public:
  virtual ~Surface() = default;

  /// World-space bound of everything that can be hit.
  [[nodiscard]] virtual Box bounds() const = 0;

  /// Whether hits and misses come with proofs. Then first_hit leaves the certificate of a ray that it proves
  /// to miss as it was, and makes it undecided where it cannot.
  [[nodiscard]] virtual bool proves() const { return false; }

  /// False when no primary ray of the tile can hit.
  [[nodiscard]] virtual bool narrow(const TileFrustum& tile) const { return tile.may_meet(bounds()); }

  /// What finds the primary rays of a whole picture together, for as long as the surface and its options and
  /// the view stay as they are; null where first_hit does it tile by tile.
  [[nodiscard]] virtual std::unique_ptr<PrimaryPass> primary(const View& view) const;

  /// What finds the shares of pixels that it covers, as long as surface, options and view stay as they are; null where
  /// it cannot tell.
  [[nodiscard]] virtual std::unique_ptr<CoveragePass> coverage(const View& view) const;

  /// For every ray the first hit in [t_min, t_max] that is nearer than the one `hits` already holds; other
  /// slots keep theirs.
  virtual void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const = 0;

  /// For every slot of `hits` that holds a hit of this object, the following crossing along the same ray,
  /// none lost or repeated; +inf where there is none.
  virtual void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const = 0;

  /// True where anything is hit. By default the first hit.
  virtual void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const;

  /// For every ray without a hit in `hits`, which this surface has looked for in vain: the sides on which it
  /// runs all the way inside the bounds (a ray that misses them has none: 0). By default 0, which is the
  /// outside of a closed surface.
  virtual void find_sides(const RayStream& rays, const HitStream& hits, RaySides (&sides)[kStreamSize]) const;

  /// For steps from hits of this object, where on the way its front ends: at a silhouette or at the domain's
  /// edge, as a share of the step, or kNoEdge. By default nothing is found.
  virtual void find_edges(const PixelLines& lines, std::span<const EdgeStep> steps,
                          std::span<float> shares) const;

  /// Position, normal and value at the hits of this object.
  virtual void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                     DressedHits& dressed) const = 0;
};

}  // namespace isocast
