#include <isocast/implicit/beams/beamed_rays_pass.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isocast {

template <class T>
void BeamedRaysPass<T>::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                                   TraceCounts& counts) const {
  if (!this->frame_.meets()) return;
  const DefaultFloatEnvironment environment;
  BlockRays<T> rays = this->frame_.template block<T>(bx, by, offset_u, offset_v, this->inputs_.eps);
  constexpr T kDeep = 4;
  rays.eps = std::max(rays.eps, kDeep * rays.pixel);
  BlockRoots<T>& roots = this->roots();
  std::uint8_t levels[kBlockPixels];
  caster_.cast(this->query_, rays, 0, true, roots, levels);
  counts.evaluations += roots.evaluations;
  std::vector<RayStream> streams;
  std::vector<HitStream*> found;
  for (int tile = 0; tile < kBlockStreams; ++tile) {
    const int x = tile % kBlockTiles, y = tile / kBlockTiles, tx = bx * kBlockTiles + x,
              ty = by * kBlockTiles + y;
    const T* const lo = roots.lo + tile * kStreamSize;
    if (std::none_of(lo, lo + kStreamSize, [](T depth) { return depth < kInfinity<T>; })) continue;
    if (!this->inputs_.surface.narrow(this->view_.frustum(tx, ty))) continue;
    RayStream& stream = streams.emplace_back();
    this->view_.fill(tx, ty, offset_u, offset_v, stream);
    found.push_back(&hits.tile(x, y));
    for (int i = 0; i < stream.size; ++i) {
      if (!(lo[i] < kInfinity<T>)) {
        stream.t_max[i] = -kInfinity<double>;
        continue;
      }
      const int slot = tile * kStreamSize + i;
      const double from = BlockFrame::distance(rays, slot_x(slot), slot_y(slot), lo[i]);
      stream.t_min[i] = std::max(stream.t_min[i], from - 0x1p-45 * std::abs(from));
    }
  }
  if (!streams.empty() && !hits.unwanted()) trace_(streams, found, counts);
}

template class BeamedRaysPass<float>;
template class BeamedRaysPass<double>;

}  // namespace isocast
