// The table of what is done to blocks of primary rays of formulas, one per instruction set.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/ray/hit.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// clear   begins a block: nothing is found
/// trace   searches a node, which is not slanted, by a tree of beams; the tape is to hold in all of `limit`,
///         which is a sixteenth of the node's window and eps longer at both ends, or more
/// cast    fills them by casting beams: with intervals or affine forms, `finer` levels below pixels, adaptive
///         or for every pixel; lo and hi bound the first part that is not thrown away
/// prove_cells  counts those of the finest cells that casting has left which are covered for sure
/// (prove_cells.h) polish  improves the guesses at those roots of a tile whose brackets begin in a range
/// guess   gives the iso-value that f is nearest to at the guesses of a tile, and its side in front of them
/// write   makes hits of the roots of a tile, each with this certificate
///
/// `registers` has room for Tape::registers times `register_bytes`, aligned to 64.
template <class T> struct BlockKernels {
  void (*clear)(const BlockRays<T>&, BlockRoots<T>&);
  void (*trace)(const FormulaQuery<T>&, const BlockRays<T>&, const BeamNode<T>&, DepthRange<T> limit,
                BlockRoots<T>&, void* registers);
  using Cast = void(const FormulaQuery<T>&, const BlockRays<T>&, BlockRoots<T>&, BlockCells<T>&, int finer,
                    bool adaptive, void* registers);
  Cast *cast_interval, *cast_affine;
  void (*prove_cells)(const FormulaQuery<T>&, const BlockRays<T>&, BlockCells<T>&, void* registers);
  void (*polish)(const FormulaQuery<T>&, const BlockRays<T>&, int tile, DepthRange<T>, PixelRoots<T>&,
                 void* registers);
  void (*guess)(const FormulaQuery<T>&, const BlockRays<T>&, int tile, PixelRoots<T>&, void* registers);
  void (*write)(const FormulaQuery<T>&, const BlockRays<T>&, const PixelRoots<T>&, int tile,
                std::uint16_t object, Certificate, HitStream&);
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
