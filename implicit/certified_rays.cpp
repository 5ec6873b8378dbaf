// Rays of `certified` that no picture orders, where it takes forms: each by its own polynomial, and those of
// which that proves nothing by inclusion.
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/copy_ray.h>

#include <array>

namespace isocast {
namespace {

// Rays of a stream that are to be solved again, from the hits that were known before.
struct RaysLeft {
  RayStream rays;
  HitStream hits;
  int slot[kStreamSize];

  explicit RaysLeft(RayKind kind) {
    rays.size = 0;
    rays.kind = kind;
    clear(hits);
  }
  void add(const RayStream& from, const HitStream& before, int i) {
    const int n = rays.size++;
    copy_ray(from, i, rays, n);
    copy_slot(before, i, hits, n);
    slot[n] = i;
  }
  void put_back(HitStream& to) const {
    for (int n = 0; n < rays.size; ++n) {
      copy_slot(hits, n, to, slot[n]);
      to.cost[slot[n]] += hits.cost[n];
    }
  }
};

}  // namespace

void ImplicitSurface::trace_certified(bool next, const RayStream& rays, HitStream& hits,
                                      TraceCounts& counts) const {
  const HitStream before = hits;
  forms_->trace(next, {&rays, 1}, std::array{&hits}, counts);
  const double longest = rays.kind == RayKind::shadow ? shadow_eps_ : eps_;
  // of other rays than the picture's there are no tiles
  RaysLeft left(rays.kind == RayKind::primary ? RayKind::reflection : rays.kind);
  for (int i = 0; i < rays.size; ++i) {
    const bool mine = is_hit(hits, i) && hits.object[i] == options_.object;
    if (hits.certificate[i] == Certificate::undecided || (mine && hits.t_hi[i] - hits.t_lo[i] > longest))
      left.add(rays, before, i);
  }
  if (left.rays.size == 0) return;
  trace_by_inclusion(next, left.rays, left.hits, counts);
  left.put_back(hits);
}

}  // namespace isocast
