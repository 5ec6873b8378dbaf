// Compiled once per instruction set: the beam tree over the native register of float and double.
#include <isocast/implicit/beams/beam_cast.h>
#include <isocast/implicit/beams/beam_tree.h>
#include <isocast/implicit/beams/block_hits.h>
#include <isocast/implicit/beams/guess_roots.h>
#include <isocast/implicit/beams/kernels.h>
#include <isocast/implicit/beams/prove_cells.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const BeamKernels beam_kernel_table;

namespace {

constexpr std::size_t larger(std::size_t a, std::size_t b) { return a > b ? a : b; }

template <class F, Real R>
void cast(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
          BlockRoots<Scalar<R>>& roots, BlockCells<Scalar<R>>& cells, int finer, bool adaptive,
          void* registers) {
  BeamCast<F, R>(query, rays, roots, cells, finer, registers).run(adaptive);
}

template <class T> constexpr BlockKernels<T> block_kernels() {
  using R = Native<T>;
  using Tree = BeamTree<AffineForm<R, 3>, R>;
  return {[](const BlockRays<T>& rays, BlockRoots<T>& roots) { BlockLeaves<R>(rays, roots).clear(); },
          [](const FormulaQuery<T>& query, const BlockRays<T>& rays, const BeamNode<T>& start,
             DepthRange<T> limit, BlockRoots<T>& roots,
             void* registers) { Tree(query, rays, roots, registers).run(start, limit); },
          cast<Interval<R>, R>,
          cast<AffineForm<R, 3>, R>,
          prove_cells<AffineForm<R, 3>, R>,
          polish_tile<R>,
          [](const FormulaQuery<T>& query, const BlockRays<T>& rays, int tile, PixelRoots<T>& roots,
             void* registers) {
            for (int first = 0; first < kStreamSize; first += kSlots)
              guess_roots<R>(query, rays, tile, first, roots, registers);
          },
          write_tile<Native<double>, T>,
          larger(Tree::kRegisterBytes, BeamCast<Interval<R>, R>::kRegisterBytes)};
}

}  // namespace

const BeamKernels beam_kernel_table = {block_kernels<float>(), block_kernels<double>()};

}  // namespace isocast::inline ISO_ISA
