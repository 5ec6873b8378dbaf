// The table of the module `reference`, the only part of the program that needs Arb, FLINT and MPFR.
#pragma once

#include <isocast/apps/reference/polynomial_terms.h>
#include <isocast/apps/reference/ray_reference.h>
#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/expression.h>

#include <memory>

namespace isocast::reference {

struct FormulaModule {
  /// A FormulaRayReference.
  std::unique_ptr<RayReference> (*make)(const Expression& expression, const Domain& domain, double time,
                                        const std::vector<double>& iso, const ReferenceOptions& options);
  PolynomialTerms (*terms)(const Expression& expression, double time);
};

}  // namespace isocast::reference
