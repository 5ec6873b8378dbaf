#include <isocast/implicit/beams/beam_cast_pass.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/rounding.h>
#include <isocast/render/camera.h>

#include <algorithm>
#include <memory>

namespace isocast {

template <class T>
void BeamCastPass<T>::cast(const BlockRays<T>& rays, BlockRoots<T>& roots, BlockCells<T>& cells) const {
  if (caster_) {
    caster_->cast(this->query_, rays, options_.finer, options_.adaptive, roots, cells.level);
    return;
  }
  const BlockKernels<T>& kernels = this->kernels();
  void* const registers = this->registers();
  const auto cast = options_.affine ? kernels.cast_affine : kernels.cast_interval;
  cast(this->query_, rays, roots, cells, options_.finer, options_.adaptive, registers);
  for (int tile = 0; tile < kBlockStreams; ++tile) kernels.guess(this->query_, rays, tile, roots, registers);
}

template <class T>
void BeamCastPass<T>::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                                 TraceCounts& counts) const {
  if (!this->frame_.meets()) return;
  const DefaultFloatEnvironment environment;
  BlockRays<T> rays = this->frame_.template block<T>(bx, by, offset_u, offset_v, this->inputs_.eps);
  rays.eps = static_cast<T>(0.5 * options_.eps) * rays.most_depth;
  thread_local const auto cells = std::make_unique<BlockCells<T>>();
  BlockRoots<T>& roots = this->roots();
  cast(rays, roots, *cells);
  counts.evaluations += roots.evaluations;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const int x = tile % kBlockTiles, y = tile / kBlockTiles, first = tile * kStreamSize;
    if (slot_x(first) >= rays.columns || slot_y(first) >= rays.rows) continue;
    HitStream& found = hits.tile(x, y);
    for (int i = 0; i < kStreamSize; ++i) found.cost[i] += cells->level[first + i];
    const T* const lo = roots.lo + first;
    if (std::none_of(lo, lo + kStreamSize, [](T depth) { return depth < kInfinity<T>; })) continue;
    // beams are cut to the domain face by face: they may pass by its edges
    const int tx = bx * kBlockTiles + x, ty = by * kBlockTiles + y;
    if (!this->inputs_.surface.narrow(this->view_.frustum(tx, ty))) continue;
    this->kernels().write(this->query_, rays, roots, tile, this->inputs_.object, Certificate::undecided,
                          found);
    this->note_components(tx, ty, offset_u, offset_v, found);
  }
}

template class BeamCastPass<float>;
template class BeamCastPass<double>;

}  // namespace isocast
