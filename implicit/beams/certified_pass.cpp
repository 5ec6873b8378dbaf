#include <isocast/implicit/beams/certified_pass.h>
#include <isocast/implicit/beams/pruned_block.h>
#include <isocast/implicit/open_rays.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/rounding.h>
#include <isocast/render/camera.h>

#include <cmath>
#include <stop_token>

namespace isocast {
namespace {

// Whether it holds for a slot of a tile; all are asked, side by side.
template <class Holds> bool any_slot(Holds holds) {
  bool found = false;
  for (int i = 0; i < kStreamSize; ++i) found |= holds(i);
  return found;
}

}  // namespace

template <class T>
void CertifiedPass<T>::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                                  TraceCounts& counts) const {
  if (!this->frame_.meets()) return;
  const DefaultFloatEnvironment environment;
  const BlockRays<T> rays = this->frame_.template block<T>(bx, by, offset_u, offset_v, this->inputs_.eps);
  BlockRoots<T>& roots = this->roots();
  const BlockKernels<T>& kernels = this->kernels();
  void* const registers = this->registers();
  kernels.clear(rays, roots);
  bool unwanted = false;
  const std::stop_callback stopped(hits.stop(), [&] { __atomic_store_n(&unwanted, true, __ATOMIC_RELAXED); });
  roots.unwanted = &unwanted;
  const DepthRange<T> all = {-rays.before, rays.most_depth};
  if (this->inputs_.prunes)
    PrunedBlock<T>(this->query_, this->inputs_, kernels, this->frame_.box(), rays, roots).trace(all);
  else {
    constexpr DepthRange<T> everywhere = {-kInfinity<T>, kInfinity<T>};
    kernels.trace(this->query_, rays, node_of(0, 0, kBlockSide, all), everywhere, roots, registers);
    for (int tile = 0; tile < kBlockStreams; ++tile)
      kernels.polish(this->query_, rays, tile, everywhere, roots, registers);
  }
  roots.unwanted = nullptr;
  if (hits.unwanted()) return;
  counts.evaluations += roots.evaluations;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const T* const lo = roots.lo + tile * kStreamSize;
    if (!any_slot([lo](int i) { return std::abs(lo[i]) < kInfinity<T>; })) continue;
    const int x = tile % kBlockTiles, y = tile / kBlockTiles;
    HitStream& found = hits.tile(x, y);
    kernels.write(this->query_, rays, roots, tile, this->inputs_.object, Certificate::proved_hit, found);
    this->note_components(bx * kBlockTiles + x, by * kBlockTiles + y, offset_u, offset_v, found);
  }
  solve_open_rays(bx, by, offset_u, offset_v, rays, roots, hits, counts);
}

template <class T>
void CertifiedPass<T>::solve_open_rays(int bx, int by, double offset_u, double offset_v,
                                       const BlockRays<T>& rays, const BlockRoots<T>& roots, BlockHits& hits,
                                       TraceCounts& counts) const {
  OpenRays& open = OpenRays::of_thread(this->inputs_.surface);
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    if (hits.unwanted()) return;
    const T *const lo = roots.lo + tile * kStreamSize, *const unclear = roots.unclear + tile * kStreamSize;
    if (!any_slot([&](int i) { return unclear[i] < lo[i]; })) continue;
    const int x = tile % kBlockTiles, y = tile / kBlockTiles;
    open.begin(this->view_, bx * kBlockTiles + x, by * kBlockTiles + y, offset_u, offset_v, hits.tile(x, y));
    for (int i = 0; i < kStreamSize; ++i) {
      if (!(unclear[i] < lo[i])) continue;
      const int p = i / kPacketSize, l = i % kPacketSize;
      const double from = BlockFrame::distance(rays, x * kTileSize + p % 4 * 4 + l % 4,
                                               y * kTileSize + p / 4 * 4 + l / 4, unclear[i]);
      open.add(i, from - 0x1p-45 * std::abs(from), counts);
    }
  }
  open.solve(counts);
}

template class CertifiedPass<float>;
template class CertifiedPass<double>;

}  // namespace isocast
