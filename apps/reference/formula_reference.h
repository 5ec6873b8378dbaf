// The truth about a formula and a ray: every root of f - iso along it, in exact arithmetic or in balls.
#pragma once

#include <isocast/apps/reference/exact_formula.h>
#include <isocast/apps/reference/formula_roots.h>
#include <isocast/math/transform.h>

namespace isocast::reference {

/// f = iso of the formula as it was parsed, with its literals as rational numbers; iso and time are taken
/// exactly. Slow, and shares nothing with the methods but the graph. solve() may be called from any thread.
class FormulaReference {
 public:
  /// Throws InputError if iso or time is not finite.
  explicit FormulaReference(const Expression& expression, double iso = 0, double time = 0);

  /// The roots in [t0, t1] of f(p(t)) - iso for p(t) = o + t d, all of it taken exactly.
  ///
  /// polynomials  with rational coefficients: exact, always decided but where f is iso all along the ray
  /// others       balls; a touch is found only where no number is rounded, else it is a doubt; neither a jump
  /// nor
  ///              a pole is a root
  /// width        0: 1e-12 (t1 - t0)
  /// throws       InputError unless all numbers are finite and t0 < t1
  [[nodiscard]] FormulaRoots solve(const Double3& o, const Double3& d, double t0, double t1,
                                   const ReferenceOptions& options = {}) const;

  /// Whether solve() is exact.
  [[nodiscard]] bool polynomial() const { return polynomial_; }

 private:
  ExactFormula formula_;
  bool polynomial_;
};

}  // namespace isocast::reference
