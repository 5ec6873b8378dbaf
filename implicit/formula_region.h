// A solid given by a formula.
#pragma once

#include <isocast/implicit/expression/expression.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/implicit/quadric.h>
#include <isocast/ray/region.h>

namespace isocast {

/// The points of world space where g(x, y, z, w = time) <= 0; those where g has no value are outside.
///
/// sure    by intervals in double with outward rounding, over the box of the points from t_lo to t_hi
/// narrow  where g is a polynomial of degree 1 or 2: half spaces, balls (Quadric::inside)
class FormulaRegion final : public Region {
 public:
  explicit FormulaRegion(const Expression& g, double time = 0);

  void locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const override;
  [[nodiscard]] bool narrows() const override { return quadric_.has_value(); }
  void narrow(RayStream& rays) const override;

 private:
  Tape tape_;
  double time_;
  std::optional<Quadric> quadric_;
};

}  // namespace isocast
