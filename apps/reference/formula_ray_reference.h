// The truth about a formula in a box, for several iso-values.
#pragma once

#include <isocast/apps/reference/formula_reference.h>
#include <isocast/apps/reference/ray_reference.h>
#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/tape.h>

namespace isocast::reference {

/// FormulaReference for each iso-value. The ray is clipped to the domain in double precision, by the same
/// operations as the program's. Scale and slope are those of doubles.
class FormulaRayReference final : public RayReference {
 public:
  /// Throws InputError for iso-values and a time that are not finite.
  FormulaRayReference(const Expression& expression, const Domain& domain, double time,
                      std::vector<double> iso, const ReferenceOptions& options = {});

  [[nodiscard]] RayTruth solve(const Double3& o, const Double3& d, double t0, double t1) const override;
  [[nodiscard]] double unit() const override { return unit_; }
  [[nodiscard]] std::string identity() const override { return identity_; }

 private:
  Domain domain_;
  double time_, unit_;
  std::vector<double> iso_;
  ReferenceOptions options_;
  std::vector<FormulaReference> references_;
  Tape tape_;
  std::string identity_;
};

}  // namespace isocast::reference
