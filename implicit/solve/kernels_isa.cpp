// Compiled once per instruction set: every solver over the native register of float and double.
#include <isocast/implicit/solve/bisection.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/implicit/solve/polish.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const FormulaKernels formula_kernel_table;

namespace {

template <class Method, class T> constexpr FormulaSolver<T> solver() {
  using Finish = Polish<Native<T>>;
  constexpr std::size_t bytes =
      Method::kRegisterBytes > Finish::kRegisterBytes ? Method::kRegisterBytes : Finish::kRegisterBytes;
  return {[](const FormulaQuery<T>& query, const SegmentStream<T>& stream, SegmentRoots<T>& roots,
             void* registers) {
            Method(query, stream, roots, registers).run();
            Finish(query, stream, roots, registers).run();
          },
          bytes};
}
template <class T> constexpr auto interval = solver<Bisection<Interval<Native<T>>, Native<T>>, T>();
template <class T> constexpr auto affine = solver<Bisection<AffineForm<Native<T>, 1>, Native<T>>, T>();

}  // namespace

// the order of FormulaMethod
const FormulaKernels formula_kernel_table = {{interval<float>, affine<float>},
                                             {interval<double>, affine<double>}};

}  // namespace isocast::inline ISO_ISA
