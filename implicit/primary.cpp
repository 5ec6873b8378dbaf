#include <isocast/implicit/beams/beam_cast_pass.h>
#include <isocast/implicit/beams/beamed_rays_pass.h>
#include <isocast/implicit/beams/certified_pass.h>
#include <isocast/implicit/beams/formula_coverage.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/render/stream_pass.h>

namespace isocast {
namespace {

template <class T>
std::unique_ptr<PrimaryPass> make_pass(const View& view, const FormulaQuery<T>& query,
                                       const FormulaPassInputs& inputs, const FormulaMethodChoice& method,
                                       const BeamCaster* caster = nullptr) {
  if (method.pass == FormulaPass::certified) return std::make_unique<CertifiedPass<T>>(view, query, inputs);
  const BeamCastOptions options = {method.depth_eps, method.finer, method.pass == FormulaPass::beam_adaptive,
                                   method.affine_beams};
  return std::make_unique<BeamCastPass<T>>(view, query, inputs, options, caster);
}

}  // namespace

FormulaPassInputs ImplicitSurface::pass_inputs() const {
  FormulaPassInputs inputs = {*this, tape_,        pruning_.prunes, {},
                              eps_,  options_.isa, options_.object, nullptr};
  if (options_.method.options.delta == 0) inputs.levels = options_.iso;
  if (components_) inputs.components = &*components_;
  return inputs;
}

template <class T>
std::unique_ptr<PrimaryPass> ImplicitSurface::device_pass(const View& view,
                                                          const FormulaQuery<T>& query) const {
  const FormulaMethodChoice& method = options_.method;
  if (method.pass == FormulaPass::beam_uniform || method.pass == FormulaPass::beam_adaptive)
    return make_pass(view, query, pass_inputs(), method, beam_caster_.get());
  const auto trace = [this](auto rays, auto hits, TraceCounts& counts) {
    trace_on_device(false, rays, hits, counts);
  };
  if (!beam_caster_) return std::make_unique<StreamPass>(*this, view, trace);
  return std::make_unique<BeamedRaysPass<T>>(view, query, pass_inputs(), *beam_caster_, trace);
}

std::unique_ptr<PrimaryPass> ImplicitSurface::primary(const View& view) const {
  if (segment_solver_)
    return options_.double_precision ? device_pass(view, double_query_) : device_pass(view, float_query_);
  if (frustum_ && options_.device && !components_)
    return std::make_unique<StreamPass>(*this, view, [this](auto rays, auto hits, TraceCounts& counts) {
      frustum_->trace(false, rays, hits, counts);
    });
  const FormulaMethodChoice& method = options_.method;
  if (method.pass == FormulaPass::none) return nullptr;
  // components are told from rays
  if (frustum_) return components_ ? nullptr : frustum_->primary(view);
  if (forms_)
    if (auto pass = forms_->primary(view, {this, eps_})) return pass;
  if (options_.double_precision) return make_pass(view, double_query_, pass_inputs(), method);
  return make_pass(view, float_query_, pass_inputs(), method);
}

std::unique_ptr<CoveragePass> ImplicitSurface::coverage(const View& view) const {
  if (options_.double_precision)
    return std::make_unique<FormulaCoverage<double>>(view, double_query_, pass_inputs());
  return std::make_unique<FormulaCoverage<float>>(view, float_query_, pass_inputs());
}

}  // namespace isocast
