// What a walk asks of the operands.
#include <isocast/ray/csg_walk.h>

#include <algorithm>

namespace isocast {

// The first crossings with operand k, and the sides in front of them.
void CsgWalk::trace(std::size_t k, TraceCounts& counts) {
  HitStream& hits = waiting_[k];
  const Surface& surface = *csg_.operands_[k].surface;
  clear(hits);
  if (csg_.proves_) std::ranges::fill(hits.certificate, Certificate::proved_miss);
  const RayStream& rays = rays_of(k);
  surface.first_hit(rays, hits, counts);
  RaySides found[kStreamSize];
  if (std::any_of(hits.t, hits.t + rays.size, [](double t) { return !(t < __builtin_inf()); }))
    surface.find_sides(rays, hits, found);
  for (int i = 0; i < rays.size; ++i) {
    if (is_hit(hits, i)) {
      sides_.set(k, i, hits.sides[i]);
      continue;
    }
    if (carries(k, i)) sides_.set(k, i, rays_.start_sides[i] & kSidesOfOperand);
    else {
      sides_.set(k, i, found[i].below);
      if (!settled_[i] && !found[i].sure) doubt_.set(i);
    }
    sides_.stay(k, i);
  }
}

// The rays as operand k sees them: one that starts on another operand does not start on it.
const RayStream& CsgWalk::rays_of(std::size_t k) {
  for (int i = 0; i < rays_.size && starts_here_.any(); ++i) {
    if (!starts_here_[i]) continue;
    carried_.start_object[i] = carries(k, i) ? csg_.object_ : kNoObject;
    carried_.start_sides[i] = rays_.start_sides[i] & kSidesOfOperand;
  }
  return carried_;
}

bool CsgWalk::carries(std::size_t k, int i) const {
  return rays_.start_object[i] == csg_.object_ && rays_.start_sides[i] >> CsgSurface::kMostIsos == k;
}

// Asks the operands for what lies behind the crossings that were taken.
void CsgWalk::follow(const RaySet& open, TraceCounts& counts) {
  HitStream asked;
  for (std::size_t k = 0; k < count_; ++k) {
    const RaySet taken = taken_[k] & open;
    if (taken.none()) continue;
    taken_[k] &= ~taken;
    asked = waiting_[k];
    bool doubtful = false;
    for (int i = 0; i < rays_.size; ++i) {
      if (!taken[i] || stretches_[k][i].leaps_behind(waiting_[k], i)) forget(asked, i);
      doubtful = doubtful || (taken[i] && waiting_[k].certificate[i] == Certificate::undecided);
    }
    csg_.operands_[k].surface->next_hit(rays_of(k), asked, counts);
    if (doubtful) follow_doubtful(k, taken, asked, counts);
    for (int i = 0; i < rays_.size; ++i) {
      if (!taken[i]) continue;
      // a hit that was taken has left its certificate behind
      if (!is_hit(asked, i) && asked.certificate[i] == Certificate::proved_hit)
        asked.certificate[i] = Certificate::proved_miss;
      copy_slot(asked, waiting_[k], i);
      waiting_[k].cost[i] = asked.cost[i];
      if (is_hit(asked, i)) sides_.set(k, i, asked.sides[i]);
    }
  }
}

// Behind undecided crossings with operand k: a ray that keeps following the surface leaps as far as it has
// followed it, and what lies behind the last of its crossings is looked up.
void CsgWalk::follow_doubtful(std::size_t k, const RaySet& taken, HitStream& asked, TraceCounts& counts) {
  const Surface& surface = *csg_.operands_[k].surface;
  const auto ahead = std::make_unique<RayStream>(rays_of(k));
  const auto found = std::make_unique<HitStream>();
  clear(*found);
  bool leaps = false;
  for (int i = 0; i < rays_.size; ++i) {
    const HitStream& hits = waiting_[k];
    const bool doubtful = taken[i] && hits.certificate[i] == Certificate::undecided && !is_hit(asked, i),
               leap = doubtful && asked.object[i] == kNoObject;
    ahead->start_object[i] = kNoObject;
    if (!doubtful) ahead->t_max[i] = 0, ahead->t_min[i] = 1;
    else ahead->t_min[i] = hits.t_hi[i] + (leap ? stretches_[k][i].length(hits, i) : 0);
    found->object[i] = leap ? kNoObject : csg_.object_;
    leaps = leaps || leap;
  }
  if (leaps) surface.first_hit(*ahead, *found, counts);
  RaySides sides[kStreamSize];
  surface.find_sides(*ahead, *found, sides);
  for (int i = 0; i < rays_.size; ++i) {
    if (!(ahead->t_min[i] <= ahead->t_max[i])) continue;
    if (is_hit(*found, i)) copy_slot(*found, asked, i);
    else sides_.set(k, i, sides[i].below);
    asked.certificate[i] = Certificate::undecided;
  }
}

}  // namespace isocast
