// The table of what is done to blocks of primary rays of formulas, one per instruction set.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/ray/hit.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// trace   fills the roots of a block
/// polish  improves the guesses at those of a tile
/// write   makes hits of them
/// `registers` has room for Tape::registers times `register_bytes`, aligned to 64.
template <class T> struct BlockKernels {
  void (*trace)(const FormulaQuery<T>&, const BlockRays<T>&, BlockRoots<T>&, void* registers);
  void (*polish)(const FormulaQuery<T>&, const BlockRays<T>&, int tile, BlockRoots<T>&, void* registers);
  void (*write)(const FormulaQuery<T>&, const BlockRays<T>&, const BlockRoots<T>&, int tile,
                std::uint16_t object, HitStream&);
  std::size_t register_bytes;
};
struct BeamKernels {
  BlockKernels<float> for_float;
  BlockKernels<double> for_double;

  template <class T> [[nodiscard]] const BlockKernels<T>& of() const {
    if constexpr (sizeof(T) == 4) return for_float;
    else return for_double;
  }
};

/// The table of an instruction set that runs here. The same block gives the same bits in all of them.
[[nodiscard]] const BeamKernels& beam_kernels(Isa isa);

}  // namespace isocast
