// Formulas of many operands: a block is searched part by part, each with what it needs of the tape.
#pragma once

#include <isocast/implicit/beams/block_pass.h>
#include <isocast/implicit/expression/prune.h>

namespace isocast {

template <class T> constexpr BeamNode<T> node_of(int x, int y, int size, DepthRange<T> all) {
  return {x, y, size, false, false, false, T(0), T(0), T(0), all, all};
}
/// The block is quartered and then cut in depth, front to back, as long as tapes are long; each part prunes
/// the tape of the part that it is of.
template <class T> class PrunedBlock {
 public:
  PrunedBlock(const FormulaQuery<T>& query, const FormulaPassInputs& inputs, const BlockKernels<T>& kernels,
              const Box& domain, const BlockRays<T>& rays, BlockRoots<T>& roots);

  /// Fills the block's roots between these depths, and improves the guesses at them.
  void trace(DepthRange<T> all) { search(inputs_.tape, 0, 0, kBlockSide, all, 0); }

 private:
  void search(const Tape& tape, int x, int y, int size, DepthRange<T> part, int level);
  /// By as much as a search may leave its part.
  [[nodiscard]] DepthRange<T> widened(DepthRange<T> part) const;
  [[nodiscard]] bool meets(int x, int y, int size, DepthRange<T> part) const;
  const Tape& pruned(const Tape& tape, int x, int y, int size, DepthRange<T> part, int level);

  FormulaQuery<T> query_;
  const FormulaPassInputs& inputs_;
  const BlockKernels<T>& kernels_;
  const Box& domain_;
  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  void* registers_;
};

}  // namespace isocast
