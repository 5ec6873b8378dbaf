#include <isocast/ray/box_surface.h>
#include <isocast/ray/csg_walk.h>

#include <algorithm>

namespace isocast {
namespace {

bool is_same_ray(const RayStream& a, const RayStream& b, int i) {
  return a.ox[i] == b.ox[i] && a.oy[i] == b.oy[i] && a.oz[i] == b.oz[i] && a.dx[i] == b.dx[i] &&
         a.dy[i] == b.dy[i] && a.dz[i] == b.dz[i] && a.t_min[i] == b.t_min[i] && a.t_max[i] == b.t_max[i] &&
         a.start_object[i] == b.start_object[i] && a.start_sides[i] == b.start_sides[i];
}

}  // namespace

// The nearest crossings of every ray, for each all at one t.
//
// operand   the one whose hit this is, -1 where the solid goes on through it
// outer     the first operand that the ray enters or leaves there, or -1
// inner     per operand: rays that only cross an iso-value inside it
// doubtful  rays of which it is not known what lies behind the crossing, which is kept in `kept`
struct CsgWalk::Events {
  explicit Events(std::size_t operands) : inner(operands) {}
  void clear() {
    any.reset(), doubtful.reset();
    std::ranges::fill(operand, -1), std::ranges::fill(outer, -1);
    std::ranges::fill(inner, RaySet());
  }

  RaySet any, doubtful;
  int operand[kStreamSize], outer[kStreamSize], kept_operand[kStreamSize];
  std::vector<RaySet> inner;
  HitStream kept;
};

CsgWalk::CsgWalk(const CsgSurface& csg, const RayStream& rays, TraceCounts& counts)
    : csg_(csg),
      rays_(rays),
      count_(csg.operands_.size()),
      sides_(csg.part_, csg.operands_),
      carried_(rays),
      waiting_(std::make_unique_for_overwrite<HitStream[]>(count_)),
      taken_(count_),
      stretches_(std::make_unique<Stretch[][kStreamSize]>(count_)) {
  for (int i = 0; i < rays.size; ++i)
    starts_here_[i] = rays.t_min[i] <= rays.t_max[i] && rays.start_object[i] == csg.object_;
  for (const bool boxes : {true, false})
    for (std::size_t k = 0; k < count_; ++k) {
      const bool is_box = dynamic_cast<const BoxSurface*>(csg.operands_[k].surface.get()) != nullptr;
      if (is_box != boxes) continue;
      trace(k, counts);
      settle();
    }
}

// Rays for which it does not matter any more what other operands say ask no more.
void CsgWalk::settle() {
  settled_ = sides_.settled();
  for (int i = 0; i < rays_.size; ++i)
    if (settled_[i]) carried_.t_min[i] = 1, carried_.t_max[i] = 0;
}

// Passes the nearest waiting crossings of ray i, and marks them as taken.
void CsgWalk::take_nearest(int i, Events& events) {
  double t = Box::inf, t_hi = Box::inf;
  for (std::size_t k = 0; k < count_; ++k)
    if (waiting_[k].t[i] < t) t = waiting_[k].t[i], t_hi = waiting_[k].t_hi[i];
  if (!(t < Box::inf)) return;
  events.any.set(i);
  // nothing else may lie within the bracket, and nobody's way up to it may be in doubt
  int near = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    near += is_hit(waiting_[k], i) && waiting_[k].t_lo[i] <= t_hi;
    if (waiting_[k].certificate[i] == Certificate::undecided) doubt_.set(i);
  }
  if (near > 1) doubt_.set(i);

  bool inner = false;
  for (std::size_t k = 0; k < count_; ++k) {
    if (waiting_[k].t[i] != t) continue;
    const bool was_in = sides_.in_operand(k)[i];
    sides_.set(k, i, sides_behind(waiting_[k], i));
    taken_[k].set(i);
    if (waiting_[k].certificate[i] == Certificate::undecided) {
      events.doubtful.set(i);
      copy_slot(waiting_[k], events.kept, i);
      events.kept_operand[i] = static_cast<int>(k);
    }
    if (was_in != sides_.in_operand(k)[i]) {
      if (events.outer[i] < 0) events.outer[i] = static_cast<int>(k);
    } else if (!inner) events.inner[k].set(i), inner = true;
  }
}

// Which crossings are hits; `before`: the rays that were in the solid in front of them.
void CsgWalk::find_operands(const RaySet& before, Events& events) {
  const RaySet behind = sides_.inside();
  for (int i = 0; i < rays_.size; ++i)
    if (before[i] != behind[i]) events.operand[i] = events.outer[i];
  for (std::size_t k = 0; k < count_; ++k) {
    const RaySet inner = events.inner[k] & before & behind;
    if (inner.none()) continue;
    // an inner surface is there if without its operand the solid were not
    const RaySet there = inner & ~sides_.inside_without(k);
    for (int i = 0; i < rays_.size; ++i)
      if (there[i] && events.outer[i] < 0) events.operand[i] = static_cast<int>(k);
  }
}

void CsgWalk::emit(int i, int operand, const HitStream& found, HitStream& hits) {
  copy_slot(found, hits, i);
  hits.s[i] = crossings_[i];
  hits.iso[i] = static_cast<std::uint8_t>(csg_.first_iso_[operand] + found.iso[i]);
  hits.sides[i] = (found.sides[i] & kSidesOfOperand) | std::uint32_t(operand) << CsgSurface::kMostIsos;
  hits.object[i] = csg_.object_;
  if (csg_.proves_) hits.certificate[i] = doubt_[i] ? Certificate::undecided : Certificate::proved_hit;
  t_[i] = hits.t[i];
}

bool CsgWalk::leads_to(const RayStream& rays, const RaySet& open, const HitStream& hits) const {
  for (int i = 0; i < rays.size; ++i) {
    if (!open[i]) continue;
    const bool passed = crossings_[i] < hits.s[i] || (crossings_[i] == hits.s[i] && t_[i] == hits.t[i]);
    if (!passed || rays.kind != rays_.kind || i >= rays_.size || !is_same_ray(rays, rays_, i)) return false;
  }
  return true;
}

void CsgWalk::find(RaySet open, const int (&passed)[kStreamSize], HitStream& hits, TraceCounts& counts) {
  Events events(count_);
  follow(open, counts);
  while (open.any()) {
    const RaySet before = sides_.inside();
    events.clear();
    for (int i = 0; i < rays_.size; ++i)
      if (open[i] && !settled_[i]) take_nearest(i, events);
    find_operands(before, events);
    for (int i = 0; i < rays_.size; ++i) {
      if (!open[i]) continue;
      ++crossings_[i];
      if (!events.any[i]) {
        open.reset(i);
        for (std::size_t k = 0; k < count_; ++k)
          if (waiting_[k].certificate[i] == Certificate::undecided) doubt_.set(i);
        if (doubt_[i] && csg_.proves_) hits.certificate[i] = Certificate::undecided;
      } else if (!events.doubtful[i] && events.operand[i] >= 0 && crossings_[i] > passed[i]) {
        open.reset(i);
        emit(i, events.operand[i], waiting_[events.operand[i]], hits);
      }
    }
    follow(open, counts);
    const RaySet behind = sides_.inside();
    for (int i = 0; i < rays_.size; ++i) {
      if (!open[i] || !events.doubtful[i] || crossings_[i] <= passed[i] || behind[i] == before[i]) continue;
      open.reset(i);
      emit(i, events.kept_operand[i], events.kept, hits);
    }
  }
}

std::uint32_t CsgWalk::cost(int i) const {
  std::uint32_t cost = 0;
  for (std::size_t k = 0; k < count_; ++k) cost += waiting_[k].cost[i];
  return cost;
}

}  // namespace isocast
