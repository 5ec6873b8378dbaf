// Built with ISO_ONE_RAY, once for each rounding, in namespaces of their own.
#include <isocast/cuda/beam_body.h>
#include <isocast/cuda/formula_body.h>
#include <isocast/cuda/host_kernels.h>
#include <isocast/cuda/ray_form_body.h>

namespace isocast::inline ISO_ISA {

HostFormulaKernel formula_kernel_of(const SegmentSolverKey& key);
HostFormulaKernel ray_form_kernel_of(const RayFormKey& key);
HostFormulaKernel beam_kernel_of(const BeamCastKey& key);

namespace {

template <class Method, class T> constexpr HostFormulaKernel kernel() {
  return {
      [](const void* body, std::int32_t block, std::int32_t thread, std::int32_t threads, void* registers) {
        solve_segment<Method>(*static_cast<const SegmentWork<T>*>(body), Place{block, thread, threads},
                              registers);
      },
      kRegisterBytes<Method, T>};
}

template <class T> constexpr HostFormulaKernel ray_form_kernel() {
  return {
      [](const void* body, std::int32_t block, std::int32_t thread, std::int32_t threads, void* registers) {
        solve_ray_form<T>(*static_cast<const RayFormWork*>(body), Place{block, thread, threads}, registers);
      },
      kRayFormRegisterBytes};
}

template <class F, class T> constexpr HostFormulaKernel beam_kernel() {
  return {
      [](const void* body, std::int32_t block, std::int32_t thread, std::int32_t threads, void* registers) {
        cast_beams<F>(*static_cast<const BeamWork<T>*>(body), Place{block, thread, threads}, registers);
      },
      sizeof(F)};
}

template <class T> HostFormulaKernel kernel_of(FormulaMethod method) {
  switch (method) {
    case FormulaMethod::affine: return kernel<AffineSolver<T>, T>();
    case FormulaMethod::amp_sign: return kernel<AmpSignSolver<T>, T>();
    case FormulaMethod::amp_taylor: return kernel<AmpTaylorSolver<T>, T>();
    default: return kernel<IntervalSolver<T>, T>();
  }
}

}  // namespace

HostFormulaKernel formula_kernel_of(const SegmentSolverKey& key) {
  return key.double_precision ? kernel_of<double>(key.method) : kernel_of<float>(key.method);
}

HostFormulaKernel ray_form_kernel_of(const RayFormKey& key) {
  return key.single ? ray_form_kernel<float>() : ray_form_kernel<double>();
}

HostFormulaKernel beam_kernel_of(const BeamCastKey& key) {
  if (key.affine)
    return key.double_precision ? beam_kernel<AffineBeam<double>, double>()
                                : beam_kernel<AffineBeam<float>, float>();
  return key.double_precision ? beam_kernel<IntervalBeam<double>, double>()
                              : beam_kernel<IntervalBeam<float>, float>();
}

}  // namespace isocast::inline ISO_ISA
