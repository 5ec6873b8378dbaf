#include <isocast/implicit/beams/certified_pass.h>
#include <isocast/implicit/beams/pruned_block.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/rounding.h>
#include <isocast/render/camera.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// Rays that beams left open, gathered from tiles.
struct OpenRays {
  RayStream rays;
  HitStream hits;
  HitStream* to[kStreamSize];
  int slot[kStreamSize];

  void add(const RayStream& tile, int i, double from, HitStream& found) {
    const int n = rays.size++;
    rays.ox[n] = tile.ox[i], rays.oy[n] = tile.oy[i], rays.oz[n] = tile.oz[i];
    rays.dx[n] = tile.dx[i], rays.dy[n] = tile.dy[i], rays.dz[n] = tile.dz[i];
    rays.t_min[n] = std::max(tile.t_min[i], from), rays.t_max[n] = tile.t_max[i];
    rays.start_object[n] = kNoObject, rays.start_sides[n] = 0;
    to[n] = &found, slot[n] = i;
  }
  void solve(const Surface& surface, TraceCounts& counts) {
    if (rays.size == 0) return;
    // solved each for itself, as rays are that do not come from the camera
    rays.kind = RayKind::reflection;
    clear(hits);
    std::fill_n(hits.certificate, rays.size, Certificate::proved_miss);
    surface.first_hit(rays, hits, counts);
    for (int n = 0; n < rays.size; ++n) {
      HitStream& found = *to[n];
      const int i = slot[n];
      found.cost[i] += hits.cost[n];
      if (hits.t[n] < found.t[i]) copy_hit(n, found, i);
      else if (!is_hit(hits, n) && hits.certificate[n] == Certificate::undecided)
        found.certificate[i] = Certificate::undecided;
    }
    rays.size = 0;
  }

 private:
  void copy_hit(int n, HitStream& found, int i) const {
    found.t[i] = hits.t[n], found.t_lo[i] = hits.t_lo[n], found.t_hi[i] = hits.t_hi[n];
    found.cell[0][i] = hits.cell[0][n];
    found.sides[i] = hits.sides[n];
    found.object[i] = hits.object[n];
    found.iso[i] = hits.iso[n];
    found.certificate[i] = hits.certificate[n];
  }
};

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
  const DepthRange<T> all = {-rays.before, rays.most_depth};
  if (this->inputs_.prunes)
    PrunedBlock<T>(this->query_, this->inputs_, kernels, this->frame_.box(), rays, roots).trace(all);
  else {
    constexpr DepthRange<T> everywhere = {-kInfinity<T>, kInfinity<T>};
    kernels.trace(this->query_, rays, node_of(0, 0, kBlockSide, all), everywhere, roots, registers);
    for (int tile = 0; tile < kBlockStreams; ++tile)
      kernels.polish(this->query_, rays, tile, everywhere, roots, registers);
  }
  counts.evaluations += roots.evaluations;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const T* const lo = roots.lo + tile * kStreamSize;
    if (std::none_of(lo, lo + kStreamSize, [](T depth) { return std::abs(depth) < kInfinity<T>; })) continue;
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
  thread_local const auto open = std::make_unique_for_overwrite<OpenRays>();
  thread_local const auto tile_rays = std::make_unique_for_overwrite<RayStream>();
  open->rays.size = 0;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    if (hits.unwanted()) return;
    const int x = tile % kBlockTiles, y = tile / kBlockTiles;
    const T *const lo = roots.lo + tile * kStreamSize, *const unclear = roots.unclear + tile * kStreamSize;
    bool filled = false;
    for (int i = 0; i < kStreamSize; ++i) {
      if (!(unclear[i] < lo[i])) continue;
      if (!filled)
        this->view_.fill(bx * kBlockTiles + x, by * kBlockTiles + y, offset_u, offset_v, *tile_rays);
      filled = true;
      const int p = i / kPacketSize, l = i % kPacketSize;
      const double from = BlockFrame::distance(rays, x * kTileSize + p % 4 * 4 + l % 4,
                                               y * kTileSize + p / 4 * 4 + l / 4, unclear[i]);
      open->add(*tile_rays, i, from - 0x1p-45 * std::abs(from), hits.tile(x, y));
      if (open->rays.size == kStreamSize) open->solve(this->inputs_.surface, counts);
    }
  }
  open->solve(this->inputs_.surface, counts);
}

template class CertifiedPass<float>;
template class CertifiedPass<double>;

}  // namespace isocast
