#include <isocast/implicit/beams/certified_pass.h>
#include <isocast/implicit/implicit_surface.h>

namespace isocast {

std::unique_ptr<PrimaryPass> ImplicitSurface::primary(const View& view) const {
  if (options_.method.pass == FormulaPass::none) return nullptr;
  // components are told from rays
  if (frustum_) return components_ ? nullptr : frustum_->primary(view);
  const FormulaPassInputs inputs = {*this,        tape_.registers, eps_,
                                    options_.isa, options_.object, components_ ? &*components_ : nullptr};
  if (options_.double_precision) return std::make_unique<CertifiedPass<double>>(view, double_query_, inputs);
  return std::make_unique<CertifiedPass<float>>(view, float_query_, inputs);
}

}  // namespace isocast
