#include <isocast/apps/reference/formula_module.h>
#include <isocast/apps/reference/formula_ray_reference.h>
#include <isocast/base/module.h>

namespace isocast::reference {
namespace {

std::unique_ptr<RayReference> make(const Expression& expression, const Domain& domain, double time,
                                   const std::vector<double>& iso, const ReferenceOptions& options) {
  return std::make_unique<FormulaRayReference>(expression, domain, time, iso, options);
}

constexpr FormulaModule kTable = {make, polynomial_terms};

}  // namespace
}  // namespace isocast::reference

ISO_EXPORT_MODULE(isocast::reference::kTable)
