// Compiled once per instruction set: the beam tree over the native register of float and double.
#include <isocast/implicit/beams/beam_tree.h>
#include <isocast/implicit/beams/block_hits.h>
#include <isocast/implicit/beams/kernels.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const BeamKernels beam_kernel_table;

namespace {

template <class T> constexpr BlockKernels<T> block_kernels() {
  using R = Native<T>;
  using Tree = BeamTree<AffineForm<R, 3>, R>;
  return {[](const FormulaQuery<T>& query, const BlockRays<T>& rays, BlockRoots<T>& roots, void* registers) {
            Tree(query, rays, roots, registers).run();
          },
          polish_tile<R>, write_tile<Native<double>, T>, Tree::kRegisterBytes};
}

}  // namespace

const BeamKernels beam_kernel_table = {block_kernels<float>(), block_kernels<double>()};

}  // namespace isocast::inline ISO_ISA
