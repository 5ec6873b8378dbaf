// The table of formula solvers, one per instruction set.
#pragma once

#include <isocast/implicit/solve/beam.h>
#include <isocast/implicit/solve/segment.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// The first kSolverCount are in these tables; frustum methods are in the order of RootFinder
/// (implicit/frustum/finder.h).
enum class FormulaMethod : std::uint8_t {
  interval,
  affine,
  mitchell,
  interval_newton,
  amp_sign,
  amp_taylor,
  frustum_lr,
  frustum_mr,
  frustum_lr_mult,
  frustum_mr_mult,
  frustum_schneider,
  frustum_clip
};
inline constexpr int kSolverCount = 6, kFormulaMethodCount = 12;

/// f, its gradient and that with length 1 (or 0) at the first `size` positions; the other numbers are not
/// used but must be there.
struct alignas(64) GradientStream {
  double position[3][kStreamSize], value[kStreamSize], gradient[3][kStreamSize], normal[3][kStreamSize];
  int size;
};

/// A method's functions; those that march have nothing to narrow beams by. `registers` has room for
/// Tape::registers times `register_bytes`, aligned to 64.
template <class T> struct FormulaSolver {
  using Solve = void(const FormulaQuery<T>&, const SegmentStream<T>&, SegmentRoots<T>&, void* registers);
  using Narrow = void(const FormulaQuery<T>&, BeamStream<T>&, void* registers);
  Solve* solve;
  Narrow* narrow;
  std::size_t register_bytes;
};
template <class T> struct FormulaSolvers { FormulaSolver<T> of[kSolverCount]; };
/// find_gradients  `registers` as a solver's, with room for `gradient_bytes` each
struct FormulaKernels {
  FormulaSolvers<float> for_float;
  FormulaSolvers<double> for_double;
  void (*find_gradients)(const TapeView&, double time, GradientStream&, void* registers);
  std::size_t gradient_bytes;

  template <class T> [[nodiscard]] const FormulaSolver<T>& solver(FormulaMethod method) const {
    const auto i = static_cast<std::size_t>(method);
    if constexpr (sizeof(T) == 4) return for_float.of[i];
    else return for_double.of[i];
  }
};

/// The table of an instruction set that runs here. The same segments give the same bits in all of them.
///
/// nearest  inclusions whose bounds are the nearest numbers: what such a kernel calls proved is not. Without
///          the marching methods
[[nodiscard]] const FormulaKernels& formula_kernels(Isa isa, bool nearest = false);

}  // namespace isocast
