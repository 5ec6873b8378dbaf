#include <isocast/ray/box_surface.h>
#include <isocast/ray/csg_walk.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr int kOperandShift = CsgSurface::kMostIsos;
constexpr std::uint32_t kSidesMask = (1u << kOperandShift) - 1;

}  // namespace

// The nearest crossings of a ray, all at one t. operand: the one whose hit this is, -1 where the solid goes
// on through it.
struct CsgWalk::Event {
  int operand = -1;
  bool any = false, doubtful = false;
};

CsgWalk::CsgWalk(const CsgSurface& csg, const RayStream& rays, TraceCounts& counts)
    : csg_(csg),
      rays_(rays),
      counts_(counts),
      count_(static_cast<int>(csg.operands_.size())),
      waiting_(std::make_unique_for_overwrite<HitStream[]>(csg.operands_.size())),
      sides_(std::make_unique_for_overwrite<std::uint32_t[][kStreamSize]>(csg.operands_.size())),
      taken_(std::make_unique<bool[][kStreamSize]>(csg.operands_.size())),
      traced_(std::make_unique<bool[]>(csg.operands_.size())),
      stretches_(std::make_unique<Stretch[][kStreamSize]>(csg.operands_.size())) {
  for (int i = 0; i < rays.size; ++i)
    starts_here_ = starts_here_ || (rays.t_min[i] <= rays.t_max[i] && rays.start_object[i] == csg.object_);
  for (const bool boxes : {true, false})
    for (int k = 0; k < count_; ++k) {
      const bool is_box = dynamic_cast<const BoxSurface*>(csg.operands_[k].surface.get()) != nullptr;
      if (is_box != boxes) continue;
      trace(k);
      settle(k);
    }
}

// The first crossings with operand k, and the sides in front of them.
void CsgWalk::trace(int k) {
  HitStream& hits = waiting_[k];
  const Surface& surface = *csg_.operands_[k].surface;
  clear(hits);
  if (csg_.proves_) std::ranges::fill(hits.certificate, Certificate::proved_miss);
  const RayStream& rays = open_rays_of(k);
  surface.first_hit(rays, hits, counts_);
  RaySides found[kStreamSize];
  if (std::any_of(hits.t, hits.t + rays.size, [](double t) { return !(t < __builtin_inf()); }))
    surface.find_sides(rays, hits, found);
  for (int i = 0; i < rays.size; ++i) {
    if (is_hit(hits, i)) sides_[k][i] = hits.sides[i];
    else if (carries(k, i)) sides_[k][i] = rays_.start_sides[i] & kSidesMask;
    else {
      sides_[k][i] = found[i].below;
      doubt_[i] = doubt_[i] || (!settled_[i] && !found[i].sure);
    }
  }
  traced_[k] = true;
}

// Finds the rays for which, after operand k, it does not matter any more what others say.
void CsgWalk::settle(int k) {
  for (int i = 0; i < rays_.size; ++i) {
    if (settled_[i] || is_hit(waiting_[k], i)) continue;
    int operand = 0;
    settled_[i] = known(csg_.part_, i, operand) != Known::nothing;
    any_settled_ = any_settled_ || settled_[i];
  }
}

// What is known of a part all along the ray.
CsgWalk::Known CsgWalk::known(const CsgPart& part, int i, int& operand) const {
  if (part.operation == CsgOperation::operand) {
    const int k = operand++;
    if (!traced_[k] || is_hit(waiting_[k], i)) return Known::nothing;
    return in_operand(k, i) ? Known::inside : Known::outside;
  }
  // a union is the complement of the complements' intersection, a difference the intersection with them
  const auto turned = [](Known one) {
    return one == Known::nothing ? one : one == Known::inside ? Known::outside : Known::inside;
  };
  const bool unite = part.operation == CsgOperation::unite,
             subtract = part.operation == CsgOperation::subtract;
  Known all = Known::inside;
  for (std::size_t n = 0; n < part.parts.size(); ++n) {
    Known one = known(part.parts[n], i, operand);
    if (unite || (subtract && n > 0)) one = turned(one);
    if (all == Known::outside || one == Known::outside) all = Known::outside;
    else if (one == Known::nothing) all = Known::nothing;
  }
  return unite ? turned(all) : all;
}

// Without those that ask no more.
const RayStream& CsgWalk::open_rays_of(int k) {
  const RayStream& rays = rays_of(k);
  if (!any_settled_) return rays;
  if (!carried_) carried_ = std::make_unique<RayStream>(rays_);
  for (int i = 0; i < rays_.size; ++i)
    if (settled_[i]) carried_->t_min[i] = 1, carried_->t_max[i] = 0;
  return *carried_;
}

// The rays as operand k sees them: one that starts on another operand does not start on it.
const RayStream& CsgWalk::rays_of(int k) {
  if (!starts_here_) return carried_ ? *carried_ : rays_;
  if (!carried_) carried_ = std::make_unique<RayStream>(rays_);
  for (int i = 0; i < rays_.size; ++i) {
    if (rays_.start_object[i] != csg_.object_) continue;
    carried_->start_object[i] = carries(k, i) ? csg_.object_ : kNoObject;
    carried_->start_sides[i] = rays_.start_sides[i] & kSidesMask;
  }
  return *carried_;
}

bool CsgWalk::carries(int k, int i) const {
  return rays_.start_object[i] == csg_.object_ && rays_.start_sides[i] >> kOperandShift == unsigned(k);
}

bool CsgWalk::in_operand(int k, int i) const {
  const CsgOperand& operand = csg_.operands_[k];
  const std::uint32_t all = (1u << operand.iso_count) - 1, below = sides_[k][i] & all;
  return operand.above ? below != all : below != 0;
}

bool CsgWalk::is_inside(const CsgPart& part, int i, int& operand) const {
  if (part.operation == CsgOperation::operand) return in_operand(operand++, i);
  bool inside = is_inside(part.parts[0], i, operand);
  for (std::size_t n = 1; n < part.parts.size(); ++n) {
    const bool next = is_inside(part.parts[n], i, operand);  // always asked: it counts the operands
    if (part.operation == CsgOperation::unite) inside = inside || next;
    else inside = inside && (part.operation == CsgOperation::intersect ? next : !next);
  }
  return inside;
}
bool CsgWalk::is_inside(int i) const {
  int operand = 0;
  return is_inside(csg_.part_, i, operand);
}

// Passes the nearest waiting crossings of ray i, and marks them as taken.
CsgWalk::Event CsgWalk::take_nearest(int i) {
  double t = Box::inf, t_hi = Box::inf;
  for (int k = 0; k < count_; ++k)
    if (waiting_[k].t[i] < t) t = waiting_[k].t[i], t_hi = waiting_[k].t_hi[i];
  Event event;
  if (!(t < Box::inf)) return event;
  event.any = true;
  // nothing else may lie within the bracket, and nobody's way up to it may be in doubt
  int near = 0;
  for (int k = 0; k < count_; ++k) {
    near += is_hit(waiting_[k], i) && waiting_[k].t_lo[i] <= t_hi;
    doubt_[i] = doubt_[i] || waiting_[k].certificate[i] == Certificate::undecided;
  }
  doubt_[i] = doubt_[i] || near > 1;

  const bool before = is_inside(i);
  int inner = -1, outer = -1;
  for (int k = 0; k < count_; ++k) {
    if (waiting_[k].t[i] != t) continue;
    const bool was_in = in_operand(k, i);
    sides_[k][i] = sides_behind(waiting_[k], i);
    taken_[k][i] = true;
    if (waiting_[k].certificate[i] == Certificate::undecided) {
      event.doubtful = true;
      copy_slot(waiting_[k], doubtful_, i);
      doubtful_operand_[i] = k;
    }
    int& first = was_in == in_operand(k, i) ? inner : outer;
    if (first < 0) first = k;
  }
  inside_before_[i] = before;
  if (event.doubtful) return event;
  const bool behind = is_inside(i);
  if (before != behind) event.operand = outer;
  else if (inner >= 0 && outer < 0 && behind) {
    // an inner surface is there if without its operand the solid were not
    std::uint32_t& sides = sides_[inner][i];
    const std::uint32_t kept = sides;
    sides = csg_.operands_[inner].above ? ~0u : 0;
    if (!is_inside(i)) event.operand = inner;
    sides = kept;
  }
  return event;
}

// Asks the operands for what lies behind the crossings that were taken.
void CsgWalk::follow() {
  HitStream asked;
  for (int k = 0; k < count_; ++k) {
    const bool any = std::any_of(taken_[k], taken_[k] + rays_.size, [](bool taken) { return taken; });
    if (!any) continue;
    asked = waiting_[k];
    bool doubtful = false;
    for (int i = 0; i < rays_.size; ++i) {
      if (!taken_[k][i] || stretches_[k][i].leaps_behind(waiting_[k], i)) forget(asked, i);
      doubtful = doubtful || (taken_[k][i] && waiting_[k].certificate[i] == Certificate::undecided);
    }
    csg_.operands_[k].surface->next_hit(rays_of(k), asked, counts_);
    if (doubtful) follow_doubtful(k, asked);
    for (int i = 0; i < rays_.size; ++i) {
      if (!taken_[k][i]) continue;
      taken_[k][i] = false;
      // a hit that was taken has left its certificate behind
      if (!is_hit(asked, i) && asked.certificate[i] == Certificate::proved_hit)
        asked.certificate[i] = Certificate::proved_miss;
      copy_slot(asked, waiting_[k], i);
      waiting_[k].cost[i] = asked.cost[i];
      if (is_hit(asked, i)) sides_[k][i] = asked.sides[i];
    }
  }
}

// Behind undecided crossings with operand k: a ray that keeps following the surface leaps as far as it has
// followed it, and what lies behind the last of its crossings is looked up.
void CsgWalk::follow_doubtful(int k, HitStream& asked) {
  const Surface& surface = *csg_.operands_[k].surface;
  const auto ahead = std::make_unique<RayStream>(rays_of(k));
  const auto found = std::make_unique<HitStream>();
  clear(*found);
  bool leaps = false;
  for (int i = 0; i < rays_.size; ++i) {
    const HitStream& hits = waiting_[k];
    const bool doubtful = taken_[k][i] && hits.certificate[i] == Certificate::undecided && !is_hit(asked, i),
               leap = doubtful && asked.object[i] == kNoObject;
    ahead->start_object[i] = kNoObject;
    if (!doubtful) ahead->t_max[i] = 0, ahead->t_min[i] = 1;
    else ahead->t_min[i] = hits.t_hi[i] + (leap ? stretches_[k][i].length(hits, i) : 0);
    found->object[i] = leap ? kNoObject : csg_.object_;
    leaps = leaps || leap;
  }
  if (leaps) surface.first_hit(*ahead, *found, counts_);
  RaySides sides[kStreamSize];
  surface.find_sides(*ahead, *found, sides);
  for (int i = 0; i < rays_.size; ++i) {
    if (!(ahead->t_min[i] <= ahead->t_max[i])) continue;
    if (is_hit(*found, i)) copy_slot(*found, asked, i);
    else sides_[k][i] = sides[i].below;
    asked.certificate[i] = Certificate::undecided;
  }
}

void CsgWalk::emit(int i, int operand, const HitStream& found, int number, HitStream& hits) const {
  copy_slot(found, hits, i);
  hits.s[i] = number;
  hits.iso[i] = static_cast<std::uint8_t>(csg_.first_iso_[operand] + found.iso[i]);
  hits.sides[i] = (found.sides[i] & kSidesMask) | std::uint32_t(operand) << kOperandShift;
  hits.object[i] = csg_.object_;
  if (csg_.proves_) hits.certificate[i] = doubt_[i] ? Certificate::undecided : Certificate::proved_hit;
}

void CsgWalk::find(bool (&open)[kStreamSize], const int (&passed)[kStreamSize], HitStream& hits) {
  int taken[kStreamSize] = {};
  for (bool any = true; any;) {
    any = false;
    bool doubtful[kStreamSize] = {};
    for (int i = 0; i < rays_.size; ++i) {
      if (!open[i]) continue;
      const Event event = settled_[i] ? Event() : take_nearest(i);
      ++taken[i];
      doubtful[i] = event.doubtful;
      if (!event.any) {
        open[i] = false;
        for (int k = 0; k < count_; ++k)
          doubt_[i] = doubt_[i] || waiting_[k].certificate[i] == Certificate::undecided;
        if (doubt_[i] && csg_.proves_) hits.certificate[i] = Certificate::undecided;
      } else if (event.operand < 0 || taken[i] <= passed[i]) any = true;
      else {
        open[i] = false;
        emit(i, event.operand, waiting_[event.operand], taken[i], hits);
      }
    }
    if (any) follow();
    for (int i = 0; i < rays_.size; ++i) {
      if (!doubtful[i] || taken[i] <= passed[i] || is_inside(i) == inside_before_[i]) continue;
      open[i] = false;
      emit(i, doubtful_operand_[i], doubtful_, taken[i], hits);
    }
  }
}

std::uint32_t CsgWalk::cost(int i) const {
  std::uint32_t cost = 0;
  for (int k = 0; k < count_; ++k) cost += waiting_[k].cost[i];
  return cost;
}

}  // namespace isocast
