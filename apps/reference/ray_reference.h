// The truth along a ray behind one interface, whatever kind of surface it is.
#pragma once

#include <isocast/apps/reference/formula_roots.h>
#include <isocast/math/transform.h>

#include <string>
#include <vector>

namespace isocast::reference {

/// lo <= t <= hi; no other root lies between. `crossing`: f - iso changes sign there, else it only touches.
///
/// condition  how far the root moves, in lengths of the domain, for a change of f by its own scale along the
///            ray: scale of f over |df/dt|, over the domain's longest edge; +inf at a multiple root
/// distance   to the nearest other root of the ray, in the same unit; +inf where there is none
struct RayRoot {
  double lo, hi;
  bool crossing;
  double condition, distance;
};

/// roots   in increasing order
/// doubts  ranges of t of which nothing is known but the roots listed there; none: all is decided
/// bits    the precision that was used at most, 0 for exact arithmetic
struct RayTruth {
  std::vector<RayRoot> roots;
  std::vector<DoubtfulRange> doubts;
  int bits = 0;
  [[nodiscard]] bool decided() const { return doubts.empty(); }
};

/// solve() may be called from any thread.
class RayReference {
 public:
  virtual ~RayReference() = default;

  /// All roots in [t0, t1] of f - iso along p(t) = o + t d in world space, where f is defined; o and d are
  /// taken as they stand. Brackets are at most 1e-12 of the domain's longest edge wide, as far as doubles can
  /// tell such numbers apart. Throws InputError unless all numbers are finite and t0 < t1.
  [[nodiscard]] virtual RayTruth solve(const Double3& o, const Double3& d, double t0, double t1) const = 0;

  /// Longest edge of the domain (formulas) or of a voxel (volumes): the unit of errors, in world lengths.
  [[nodiscard]] virtual double unit() const = 0;

  /// Text of everything that the answers depend on but the ray: the key under which they may be kept.
  [[nodiscard]] virtual std::string identity() const = 0;
};

}  // namespace isocast::reference
