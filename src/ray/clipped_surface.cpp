#include <isocast/ray/clipped_surface.h>

#include <algorithm>

namespace isocast {

namespace {

// What follows a hit is looked for from there on.
const RayStream& from_start(RayStream& part, const RayStream& rays) {
  std::ranges::copy(rays.t_min, part.t_min);
  return part;
}

}  // namespace

ClippedSurface::ClippedSurface(std::shared_ptr<const Surface> surface,
                               std::vector<std::shared_ptr<const Region>> regions, std::uint16_t object)
    : surface_(std::move(surface)), regions_(std::move(regions)), object_(object) {}

void ClippedSurface::locate(const RayStream& rays, const HitStream& hits,
                            Place (&places)[kStreamSize]) const {
  std::ranges::fill(places, Place{true, true});
  for (const std::shared_ptr<const Region>& region : regions_) {
    Place one[kStreamSize];
    region->locate(rays, hits, one);
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(hits, i)) continue;
      const Place &a = places[i], &b = one[i];
      const bool surely_out = (!a.inside && a.sure) || (!b.inside && b.sure);
      places[i] = {a.inside && b.inside, surely_out || (a.sure && b.sure)};
    }
  }
}

// What lies behind the hits of `open`.
void ClippedSurface::follow(const RayStream& rays, Stretch (&stretches)[kStreamSize], HitStream& open,
                            TraceCounts& counts) const {
  const auto ahead = std::make_unique<RayStream>(rays);
  HitStream leaping;
  clear(leaping);
  bool leaps = false;
  for (int i = 0; i < rays.size; ++i) {
    ahead->start_object[i] = kNoObject;
    if (is_hit(open, i) && stretches[i].leaps_behind(open, i)) {
      ahead->t_min[i] = open.t_hi[i] + stretches[i].length(open, i);
      open.t[i] = Box::inf;
      leaps = true;
    } else ahead->t_min[i] = 1, ahead->t_max[i] = 0;
  }
  surface_->next_hit(rays, open, counts);
  if (!leaps) return;
  surface_->first_hit(*ahead, leaping, counts);
  for (int i = 0; i < rays.size; ++i)
    if (is_hit(leaping, i)) copy_slot(leaping, open, i);
}

// Replaces every hit of this object by the first one from there on that lies inside.
void ClippedSurface::pass_over(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  HitStream open = hits;  // the hits that are still to be located
  for (int i = 0; i < rays.size; ++i)
    if (open.object[i] != object_) forget(open, i);
  bool doubt[kStreamSize] = {};
  Stretch stretches[kStreamSize];
  const auto tell = [&](int i) {
    if (doubt[i] && proves()) open.certificate[i] = Certificate::undecided;
    copy_slot(open, hits, i);
    hits.cost[i] = open.cost[i];
    forget(open, i);
  };
  for (bool any = true; any;) {
    any = false;
    Place places[kStreamSize];
    locate(rays, open, places);
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(open, i)) continue;
      doubt[i] = doubt[i] || !places[i].sure;
      if (places[i].inside) {
        tell(i);
        continue;
      }
      any = true;
      doubt[i] = doubt[i] || open.certificate[i] == Certificate::undecided;
    }
    if (!any) return;
    bool asked[kStreamSize];
    for (int i = 0; i < rays.size; ++i) asked[i] = is_hit(open, i);
    follow(rays, stretches, open, counts);
    for (int i = 0; i < rays.size; ++i) {
      if (!asked[i] || is_hit(open, i)) continue;
      // a hit that was passed over has left its certificate behind
      if (open.certificate[i] == Certificate::proved_hit) open.certificate[i] = Certificate::proved_miss;
      tell(i);
    }
  }
}

// The part of the rays that may lie in the regions; null where none of them can tell.
std::unique_ptr<RayStream> ClippedSurface::narrowed(const RayStream& rays) const {
  std::unique_ptr<RayStream> part;
  for (const std::shared_ptr<const Region>& region : regions_) {
    if (!region->narrows()) continue;
    if (!part) part = std::make_unique<RayStream>(rays);
    region->narrow(*part);
  }
  return part;
}

void ClippedSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  HitStream own;
  clear(own);
  if (proves()) std::ranges::fill(own.certificate, Certificate::proved_miss);
  const std::unique_ptr<RayStream> part = narrowed(rays);
  surface_->first_hit(part ? *part : rays, own, counts);
  pass_over(part ? from_start(*part, rays) : rays, own, counts);
  for (int i = 0; i < rays.size; ++i) {
    hits.cost[i] += own.cost[i];
    if (own.t[i] < hits.t[i]) copy_slot(own, hits, i);
    else if (own.certificate[i] == Certificate::undecided) hits.certificate[i] = Certificate::undecided;
  }
}

void ClippedSurface::first_hit_inside(const RayStream& rays, const HitStream& whole, HitStream& hits,
                                      TraceCounts& counts) const {
  Place places[kStreamSize];
  locate(rays, whole, places);
  const auto rest = std::make_unique<RayStream>(rays);
  bool any = false;
  for (int i = 0; i < rays.size; ++i) {
    hits.cost[i] += whole.cost[i];
    const bool decided = whole.certificate[i] != Certificate::undecided,
               kept = is_hit(whole, i) && places[i].inside && (places[i].sure || !proves());
    if (!decided || (is_hit(whole, i) && !kept)) {
      any = true;
      continue;
    }
    rest->t_min[i] = 1, rest->t_max[i] = 0;
    if (kept && whole.t[i] < hits.t[i]) copy_slot(whole, hits, i);
  }
  if (any) first_hit(*rest, hits, counts);
}

void ClippedSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const std::unique_ptr<RayStream> part = narrowed(rays);
  const RayStream& ahead = part ? from_start(*part, rays) : rays;
  surface_->next_hit(ahead, hits, counts);
  pass_over(ahead, hits, counts);
}

}  // namespace isocast
