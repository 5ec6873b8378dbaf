#include <isocast/implicit/beams/formula_coverage.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace isocast {

template <class T>
void FormulaCoverage<T>::cover(int bx, int by, BlockCover& cover, TraceCounts& counts) const {
  std::memset(cover.share, 0, sizeof cover.share);
  std::memset(cover.open, 0, sizeof cover.open);
  cover.spare.reset(false);
  if (!this->frame_.meets()) return;
  const DefaultFloatEnvironment environment;
  BlockRays<T> rays = this->frame_.template block<T>(bx, by, 0.5, 0.5, this->inputs_.eps);
  rays.eps = std::max(rays.eps, rays.pixel);
  thread_local const auto cells = std::make_unique<BlockCells<T>>();
  BlockRoots<T>& roots = this->roots();
  const BlockKernels<T>& kernels = this->kernels();
  void* const registers = this->registers();
  kernels.cast_affine(this->query_, rays, roots, *cells, kMostFiner, true, registers);
  counts.evaluations += roots.evaluations;
  kernels.prove_cells(this->query_, rays, *cells, registers);
  counts.evaluations += cells->evaluations;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const int x = tile % kBlockTiles, y = tile / kBlockTiles, first = tile * kStreamSize;
    if (slot_x(first) >= rays.columns || slot_y(first) >= rays.rows) continue;
    const std::uint8_t* const covered = cells->covered + first;
    if (std::all_of(covered, covered + kStreamSize, [](std::uint8_t n) { return n == 0; })) continue;
    for (int i = 0; i < kStreamSize; ++i) {
      cover.share[tile][i] = static_cast<float>(covered[i]) / kFinestCells;
      cover.open[tile][i] = static_cast<float>(covered[i] - cells->proved[first + i]) / kFinestCells;
    }
    HitStream& spare = cover.spare.tile(x, y);
    kernels.guess(this->query_, rays, tile, roots, registers);
    kernels.write(this->query_, rays, roots, tile, this->inputs_.object, Certificate::undecided, spare);
    this->note_components(bx * kBlockTiles + x, by * kBlockTiles + y, 0.5, 0.5, spare);
  }
}

template class FormulaCoverage<float>;
template class FormulaCoverage<double>;

}  // namespace isocast
