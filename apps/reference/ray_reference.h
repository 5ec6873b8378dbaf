// The truth along a ray behind one interface, whatever kind of surface it is.
#pragma once

#include <isocast/apps/reference/formula_roots.h>
#include <isocast/math/transform.h>

#include <string>
#include <vector>

namespace isocast::reference {

/// lo <= t <= hi; no other root of this iso-value lies between. `crossing`: f < iso on one side and f >= iso
/// on the other, else it only touches. Where nothing is defined beside it, f counts as iso there.
///
/// iso        number of the iso-value
/// from_above of volumes: f touches the iso-value without being below it on either side. As zero counts as
///            positive there, their methods have no root in it
/// condition  how far the root moves, in unit(), for a change of f by its own scale along the ray: scale over
///            |df/dt|; rounded, and +inf at a multiple root and at a touch. The scale is the largest
///            |f - iso| among the corners of the root's cell, or of 64 points of the ray in the domain
/// distance   to the nearest other root of the ray, of any iso-value, in unit(); +inf where there is none
struct RayRoot {
  double lo, hi;
  bool crossing;
  double condition, distance;
  int iso = 0;
  bool from_above = false;
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

/// Throws InputError unless all numbers are finite and t0 < t1.
void require_ray(const Double3& o, const Double3& d, double t0, double t1);

/// Puts roots and doubts in order and sets the distances; t is worth so many of unit().
void finish(RayTruth& truth, double units_per_t);

}  // namespace isocast::reference
