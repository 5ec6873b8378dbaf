#include <isocast/implicit/beams/certified_pass.h>
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

template <class T> BeamNode<T> node_of(int x, int y, int size, DepthRange<T> all) {
  return {x, y, size, false, false, false, T(0), T(0), T(0), all, all};
}

// From the first to the last of a tile's brackets; from > to: there are none.
template <class T> DepthRange<T> depths_of(const BlockRoots<T>& roots, int tile) {
  DepthRange<T> depths = {kInfinity<T>, -kInfinity<T>};
  for (int i = tile * kStreamSize; i < (tile + 1) * kStreamSize; ++i)
    if (std::abs(roots.lo[i]) < kInfinity<T>)
      depths = {std::min(depths.from, roots.lo[i]), std::max(depths.to, roots.hi[i])};
  return depths;
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
  if (this->inputs_.prunes) trace_pruned(rays, roots);
  else trace(rays, roots);
  counts.evaluations += roots.evaluations;
  thread_local Pruner<T> pruner;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const DepthRange<T> depths = depths_of(roots, tile);
    if (!(depths.from <= depths.to)) continue;
    FormulaQuery<T> query = this->query_;
    const int x = tile % kBlockTiles, y = tile / kBlockTiles;
    if (this->inputs_.prunes)
      query.tape =
          pruned(this->inputs_.tape, rays, x * kTileSize, y * kTileSize, kTileSize, depths, pruner).view();
    kernels.polish(query, rays, tile, roots, registers);
    HitStream& found = hits.tile(x, y);
    kernels.write(query, rays, roots, tile, this->inputs_.object, Certificate::proved_hit, found);
    this->note_components(bx * kBlockTiles + x, by * kBlockTiles + y, offset_u, offset_v, found);
  }
  solve_open_rays(bx, by, offset_u, offset_v, rays, roots, hits, counts);
}

template <class T> void CertifiedPass<T>::trace(const BlockRays<T>& rays, BlockRoots<T>& roots) const {
  constexpr DepthRange<T> everywhere = {-kInfinity<T>, kInfinity<T>};
  this->kernels().trace(this->query_, rays, node_of<T>(0, 0, kBlockSide, {-rays.before, rays.most_depth}),
                        everywhere, roots, this->registers());
}

// In squares and slices of depth, each with what it needs of the tape.
template <class T> void CertifiedPass<T>::trace_pruned(const BlockRays<T>& rays, BlockRoots<T>& roots) const {
  constexpr int kSquare = 32, kSlices = 8;
  thread_local Pruner<T> of_square, of_slice;
  FormulaQuery<T> query = this->query_;
  const DepthRange<T> all = {-rays.before, rays.most_depth};
  const T slice = all.length() / kSlices, over = slice / 8 + rays.eps;
  for (int y = 0; y < rays.rows; y += kSquare)
    for (int x = 0; x < rays.columns; x += kSquare) {
      const Tape& square =
          pruned(this->inputs_.tape, rays, x, y, kSquare, {all.from - over, all.to + over}, of_square);
      for (int n = 0; n < kSlices; ++n) {
        const DepthRange<T> part = {n == 0 ? all.from : all.from + T(n) * slice,
                                    n == kSlices - 1 ? all.to : all.from + T(n + 1) * slice},
                            limit = {part.from - over, part.to + over};
        query.tape = pruned(square, rays, x, y, kSquare, limit, of_slice).view();
        this->kernels().trace(query, rays, node_of(x, y, kSquare, part), limit, roots, this->registers());
      }
    }
}

template <class T>
const Tape& CertifiedPass<T>::pruned(const Tape& tape, const BlockRays<T>& rays, int x, int y, int size,
                                     DepthRange<T> part, Pruner<T>& pruner) const {
  const Box around = BlockFrame::box_around(rays, x, y, size, part);
  Interval<double> box[3];
  for (int a = 0; a < 3; ++a) box[a] = Interval<double>(around.lo[a], around.hi[a]);
  return pruner.prune(tape, box, this->query_.time, this->inputs_.levels);
}

template <class T>
void CertifiedPass<T>::solve_open_rays(int bx, int by, double offset_u, double offset_v,
                                       const BlockRays<T>& rays, const BlockRoots<T>& roots, BlockHits& hits,
                                       TraceCounts& counts) const {
  thread_local const auto open = std::make_unique_for_overwrite<OpenRays>();
  thread_local const auto tile_rays = std::make_unique_for_overwrite<RayStream>();
  open->rays.size = 0;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
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
