// The table of formula solvers, one per instruction set.
#pragma once

#include <isocast/implicit/solve/segment.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// Solves one packet. `registers` has room for Tape::registers times `register_bytes`, aligned to 64.
struct FormulaKernels {
  using SolveFloat = void(const FormulaQuery<float>&, const SegmentPacket<float>&, SegmentRoots<float>&,
                          void* registers);
  using SolveDouble = void(const FormulaQuery<double>&, const SegmentPacket<double>&, SegmentRoots<double>&,
                           void* registers);
  SolveFloat* solve_float[kFormulaMethodCount];
  SolveDouble* solve_double[kFormulaMethodCount];
  std::size_t register_bytes;
};

/// The table of an instruction set that runs here. The same segments give the same bits in all of them.
[[nodiscard]] const FormulaKernels& formula_kernels(Isa isa);

}  // namespace isocast
