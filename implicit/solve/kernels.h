// The table of formula solvers, one per instruction set.
#pragma once

#include <isocast/implicit/solve/segment.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

enum class FormulaMethod : std::uint8_t { interval, affine, mitchell, interval_newton, amp_sign, amp_taylor };
inline constexpr int kFormulaMethodCount = 6;

/// A method's function. `registers` has room for Tape::registers times `register_bytes`, aligned to 64.
template <class T> struct FormulaSolver {
  using Solve = void(const FormulaQuery<T>&, const SegmentStream<T>&, SegmentRoots<T>&, void* registers);
  Solve* solve;
  std::size_t register_bytes;
};
struct FormulaKernels {
  FormulaSolver<float> for_float[kFormulaMethodCount];
  FormulaSolver<double> for_double[kFormulaMethodCount];

  template <class T> [[nodiscard]] const FormulaSolver<T>& solver(FormulaMethod method) const {
    const auto i = static_cast<std::size_t>(method);
    if constexpr (sizeof(T) == 4) return for_float[i];
    else return for_double[i];
  }
};

/// The table of an instruction set that runs here. The same segments give the same bits in all of them.
[[nodiscard]] const FormulaKernels& formula_kernels(Isa isa);

}  // namespace isocast
