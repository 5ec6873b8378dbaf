#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/ray/box_surface.h>
#include <isocast/ray/csg_walk.h>

#include <algorithm>

namespace isocast {
namespace {

Box intersection(const Box& a, const Box& b) {
  Box both;
  for (int c = 0; c < 3; ++c) {
    both.lo[c] = std::max(a.lo[c], b.lo[c]);
    both.hi[c] = std::min(a.hi[c], b.hi[c]);
  }
  return both.empty() ? Box() : both;
}

Box bounds_of(const CsgPart& part) {
  if (part.operation == CsgOperation::operand) return part.operand.surface->bounds();
  Box box = bounds_of(part.parts[0]);
  for (std::size_t n = 1; n < part.parts.size(); ++n) {
    if (part.operation == CsgOperation::unite) box.add(bounds_of(part.parts[n]));
    if (part.operation == CsgOperation::intersect) box = intersection(box, bounds_of(part.parts[n]));
  }
  return box;
}

// The operands in order; those that are CSGs are replaced by what they are made of.
void flatten(CsgPart& part, std::vector<CsgOperand>& operands) {
  if (part.operation == CsgOperation::operand) {
    if (const auto* const csg = dynamic_cast<const CsgSurface*>(part.operand.surface.get()))
      part = CsgPart(csg->part());
    else {
      operands.push_back(part.operand);
      return;
    }
  }
  if (part.parts.empty()) throw InputError("a CSG operation without operands, expected one or more");
  for (CsgPart& one : part.parts) flatten(one, operands);
}

}  // namespace

CsgPart closed(CsgOperand operand, const Box& box, const Transform& world_from_box, std::uint16_t object) {
  const CsgOperand faces = {std::make_shared<BoxSurface>(box, world_from_box, object)};
  return {CsgOperation::intersect,
          {},
          {{CsgOperation::operand, std::move(operand), {}}, {CsgOperation::operand, faces, {}}}};
}

CsgSurface::CsgSurface(CsgPart part, std::uint16_t object)
    : part_(std::move(part)), walks_(std::make_shared<CsgWalks>()), object_(object) {
  flatten(part_, operands_);
  for (const CsgOperand& operand : operands_) {
    if (operand.iso_count < 1 || operand.iso_count > kMostIsos)
      throw InputError(fmt::format("an operand of a CSG has {} iso-values, 1 to {} are possible",
                                   operand.iso_count, kMostIsos));
    first_iso_.push_back(iso_count_);
    iso_count_ += operand.iso_count;
    proves_ = proves_ && operand.surface->proves();
  }
  if (iso_count_ > kMostOperands)
    throw InputError(
        fmt::format("a CSG has {} iso-values and faces in all its operands, at most {} are possible",
                    iso_count_, kMostOperands));
  bounds_ = bounds_of(part_);
}

void CsgSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  HitStream own;
  clear(own);
  RaySet open;
  const int passed[kStreamSize] = {};
  for (int i = 0; i < rays.size; ++i) open[i] = rays.t_min[i] <= rays.t_max[i];
  CsgWalk walk(*this, rays, counts);
  walk.find(open, passed, own, counts);
  for (int i = 0; i < rays.size; ++i) {
    hits.cost[i] += walk.cost(i);
    if (own.t[i] < hits.t[i]) copy_slot(own, hits, i);
    else if (own.certificate[i] == Certificate::undecided) hits.certificate[i] = Certificate::undecided;
  }
}

void CsgSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  RaySet open;
  int passed[kStreamSize];
  for (int i = 0; i < rays.size; ++i) {
    open[i] = hits.object[i] == object_ && is_hit(hits, i);
    if (open[i]) passed[i] = static_cast<int>(hits.s[i]);
  }
  if (open.none()) return;
  std::unique_ptr<CsgWalk>& walk = walks_->of_threads.local()[static_cast<std::size_t>(rays.kind)];
  if (!walk || !walk->leads_to(rays, open, hits)) walk = std::make_unique<CsgWalk>(*this, rays, counts);
  for (int i = 0; i < rays.size; ++i)
    if (open[i]) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = Box::inf;
  walk->find(open, passed, hits, counts);
}

void CsgSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                       DressedHits& dressed) const {
  std::vector<bool> wanted(operands_.size());
  for (int i = 0; i < rays.size; ++i)
    if (hits.object[i] == object_ && is_hit(hits, i)) wanted[hits.sides[i] >> kMostIsos] = true;
  HitStream own;
  for (std::size_t k = 0; k < operands_.size(); ++k) {
    if (!wanted[k]) continue;
    own = hits;
    for (int i = 0; i < rays.size; ++i) {
      if (own.object[i] != object_ || !is_hit(own, i) || own.sides[i] >> kMostIsos != k) forget(own, i);
      else own.iso[i] = static_cast<std::uint8_t>(own.iso[i] - first_iso_[k]);
    }
    operands_[k].surface->dress(rays, own, wishes, dressed);
  }
}

}  // namespace isocast
