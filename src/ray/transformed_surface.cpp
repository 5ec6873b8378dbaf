#include <isocast/ray/transformed_surface.h>

#include <algorithm>

namespace isocast {

TransformedSurface::TransformedSurface(std::shared_ptr<const Surface> surface,
                                       const Transform& world_from_own, std::uint16_t own_number,
                                       std::uint16_t number)
    : surface_(std::move(surface)),
      world_from_own_(world_from_own),
      own_number_(own_number),
      number_(number) {
  if (const auto* const moved = dynamic_cast<const TransformedSurface*>(surface_.get())) {
    world_from_own_ = world_from_own_ * moved->world_from_own_;
    own_number_ = moved->own_number_;
    surface_ = std::shared_ptr<const Surface>(moved->surface_);
  }
  own_from_world_ = world_from_own_.inverse();
  const Box own = surface_->bounds();
  if (!own.empty())
    for (int corner = 0; corner < 8; ++corner) bounds_.add(world_from_own_.point(own.corner(corner)));
}

// The planes of the tile in the surface's own space.
bool TransformedSurface::narrow(const TileFrustum& tile) const {
  if (bounds_.empty()) return false;
  const auto& m = world_from_own_.m;
  TileFrustum own;
  for (int i = 0; i < 4; ++i) {
    own.normal[i] = world_from_own_.transposed_vector(tile.normal[i]);
    own.offset[i] = tile.offset[i] - dot(tile.normal[i], {m[0][3], m[1][3], m[2][3]});
  }
  return surface_->narrow(own);
}

void TransformedSurface::carry(const RayStream& rays, RayStream& own) const {
  own.size = rays.size;
  own.kind = rays.kind == RayKind::primary ? RayKind::reflection : rays.kind;  // no tile of a view here
  for (int i = 0; i < rays.size; ++i) {
    const Double3 o = own_from_world_.point({rays.ox[i], rays.oy[i], rays.oz[i]}),
                  d = own_from_world_.vector({rays.dx[i], rays.dy[i], rays.dz[i]});
    own.ox[i] = o[0], own.oy[i] = o[1], own.oz[i] = o[2];
    own.dx[i] = d[0], own.dy[i] = d[1], own.dz[i] = d[2];
    own.start_object[i] = rays.start_object[i] == number_ ? own_number_ : kNoObject;
  }
  std::copy_n(rays.t_min, rays.size, own.t_min);
  std::copy_n(rays.t_max, rays.size, own.t_max);
  std::copy_n(rays.u, rays.size, own.u);
  std::copy_n(rays.v, rays.size, own.v);
  std::copy_n(rays.id, rays.size, own.id);
  std::copy_n(rays.start_sides, rays.size, own.start_sides);
}

// This object's hits as the surface knows them.
void TransformedSurface::take_own(const RayStream& rays, const HitStream& hits, HitStream& own) const {
  for (int i = 0; i < rays.size; ++i) {
    own.cost[i] = 0;
    copy_slot(hits, own, i);
    if (hits.object[i] == number_) own.object[i] = own_number_;
    else forget(own, i);
  }
}

void TransformedSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  RayStream carried;
  carry(rays, carried);
  HitStream own;
  for (int i = 0; i < rays.size; ++i) {
    forget(own, i);
    own.cost[i] = 0;
    own.certificate[i] = proves() ? Certificate::proved_miss : Certificate::no_proof;
  }
  surface_->first_hit(carried, own, counts);
  for (int i = 0; i < rays.size; ++i) {
    hits.cost[i] += own.cost[i];
    if (own.t[i] < hits.t[i]) {
      copy_slot(own, hits, i);
      hits.object[i] = number_;
    } else if (own.certificate[i] == Certificate::undecided) {
      hits.certificate[i] = Certificate::undecided;
    }
  }
}

void TransformedSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  RayStream carried;
  carry(rays, carried);
  HitStream own;
  take_own(rays, hits, own);
  surface_->next_hit(carried, own, counts);
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != number_) continue;
    const std::uint16_t found = own.object[i];
    copy_slot(own, hits, i);
    hits.object[i] = found == own_number_ ? number_ : found;
    hits.cost[i] += own.cost[i];
  }
}

void TransformedSurface::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  RayStream carried;
  carry(rays, carried);
  surface_->any_hit(carried, hit, counts);
}

void TransformedSurface::find_sides(const RayStream& rays, const HitStream& hits,
                                    RaySides (&sides)[kStreamSize]) const {
  RayStream carried;
  carry(rays, carried);
  surface_->find_sides(carried, hits, sides);
}

void TransformedSurface::find_edges(const PixelLines& lines, std::span<const EdgeStep> steps,
                                    std::span<float> shares) const {
  PixelLines own;
  const auto vector = [&](const double(&from)[3], double(&to)[3], const auto& map) {
    std::ranges::copy(map({from[0], from[1], from[2]}), to);
  };
  const auto turned = [&](const Double3& v) { return own_from_world_.vector(v); };
  vector(lines.o, own.o, [&](const Double3& p) { return own_from_world_.point(p); });
  vector(lines.o_u, own.o_u, turned), vector(lines.o_v, own.o_v, turned);
  vector(lines.d, own.d, turned), vector(lines.d_u, own.d_u, turned), vector(lines.d_v, own.d_v, turned);
  surface_->find_edges(own, steps, shares);
}

void TransformedSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                               DressedHits& dressed) const {
  RayStream carried;
  carry(rays, carried);
  HitStream own;
  take_own(rays, hits, own);
  DressedHits looks;
  surface_->dress(carried, own, wishes, looks);
  for (int i = 0; i < rays.size; ++i) {
    if (!is_hit(own, i)) continue;
    if (wishes.normal) {
      const Double3 n = normalized(
          own_from_world_.transposed_vector({looks.normal[0][i], looks.normal[1][i], looks.normal[2][i]}));
      for (int a = 0; a < 3; ++a) dressed.normal[a][i] = n[a];
    }
    if (wishes.position) {
      const Double3 p =
          world_from_own_.point({looks.position[0][i], looks.position[1][i], looks.position[2][i]});
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = p[a];
    }
    if (wishes.value) dressed.value[i] = looks.value[i];
  }
}

}  // namespace isocast
