// Compiled once per instruction set and rounding: every solver over the native register of float and double.
#include <isocast/implicit/solve/bisection.h>
#include <isocast/implicit/solve/gradients.h>
#include <isocast/implicit/solve/marching_points.h>
#include <isocast/implicit/solve/narrow_beams.h>
#include <isocast/implicit/solve/polish.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const FormulaKernels formula_kernel_table;

namespace {

constexpr std::size_t larger(std::size_t a, std::size_t b) { return a > b ? a : b; }

// BeamForm: what beams are narrowed by, void for none
template <class Method, class BeamForm, class T> constexpr FormulaSolver<T> solver() {
  using R = Native<T>;
  FormulaSolver<T> solver = {[](const FormulaQuery<T>& query, const SegmentStream<T>& stream,
                                SegmentRoots<T>& roots, void* registers) {
                               const RayRange all = {0, stream.size};
                               Method(query, stream, roots, all, registers).run();
                               polish<R>(query, stream, roots, all, registers);
                             },
                             nullptr,
                             larger(Method::kRegisterBytes, HitLanes<R>::kPacks * sizeof(Gradient<R>))};
  if constexpr (!__is_same(BeamForm, void)) {
    solver.narrow = narrow_beams<BeamForm, R>;
    solver.register_bytes = larger(solver.register_bytes, Slots<R>::kPacks * sizeof(BeamForm));
  }
  return solver;
}
// beams are for what proves
template <class F, class BeamForm, class T> constexpr FormulaSolver<T> bisection() {
  using Method = Bisection<F, Native<T>>;
  if constexpr (kOutward) return solver<Method, BeamForm, T>();
  else return solver<Method, void, T>();
}
template <class T> constexpr auto interval = bisection<Interval<Native<T>>, Interval<Native<T>>, T>();
template <class T> constexpr auto affine = bisection<AffineForm<Native<T>, 1>, AffineForm<Native<T>, 3>, T>();
// what marches includes nothing: there is one build of it
template <bool kTaylor, class T> constexpr FormulaSolver<T> marching() {
  if constexpr (kOutward) return solver<MarchingPoints<kTaylor, Native<T>>, void, T>();
  else return {};
}
// the order of FormulaMethod; mitchell and interval_newton are interval with other options
template <class T> constexpr FormulaSolvers<T> solvers() {
  return {{interval<T>, affine<T>, interval<T>, interval<T>, marching<false, T>(), marching<true, T>()}};
}

}  // namespace

const FormulaKernels formula_kernel_table = {
    solvers<float>(), solvers<double>(), find_gradients<Native<double>>,
    kGradientPacks<Native<double>> * sizeof(Gradient<Native<double>>)};

}  // namespace isocast::inline ISO_ISA
