// What the suite `evaluate` times, per instruction set: tapes, and the same formulas compiled.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/isa/cpu.h>

namespace isocast::bench {

/// Numbers of a kind hold as many lanes as the native register; an affine form has one symbol.
enum class NumberKind : std::uint8_t { value, interval, affine, gradient };
inline constexpr int kNumberKinds = 4;
/// In the order of compiled_surfaces.h.
inline constexpr const char* kCompiledSurfaces[] = {"tangle", "barth_decic"};
inline constexpr int kCompiledCount = 2;

/// Values of one run, and registers that a tape may have.
inline constexpr int kEvaluatedValues = 256, kMostRegisters = 16;

/// f at kEvaluatedValues points, or over parts of `width` around them, `repeats` times.
///
/// block    values that the tape is run on at once: 16, 64 or 256
/// results  of each value two numbers that tell what was found: those of all, then the others of all
template <class T> struct Evaluation {
  TapeView tape;
  const T* points[3];
  T width;
  int block, repeats;
  T* results;
};

/// block_of_points  evaluate_block, on scalars
template <class T> struct Evaluators {
  using Run = void(const Evaluation<T>&);
  Run* tape[kNumberKinds];
  Run* compiled[kCompiledCount][kNumberKinds];
  Run* block_of_points;
};
struct EvaluateKernels {
  Evaluators<float> for_float;
  Evaluators<double> for_double;
  template <class T> [[nodiscard]] const Evaluators<T>& evaluators() const {
    if constexpr (sizeof(T) == 4) return for_float;
    else return for_double;
  }
};
[[nodiscard]] const EvaluateKernels& evaluate_kernels(Isa isa);

}  // namespace isocast::bench
