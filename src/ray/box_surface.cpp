#include <isocast/ray/box_surface.h>

#include <algorithm>
#include <cmath>

namespace isocast {

// The part of a ray inside the box, within `slack` at both ends; empty where near > far, unclear where
// roundings could tell otherwise. grazes: along a face, within them.
struct BoxSurface::Chord {
  double near, far, near_slack, far_slack;
  bool grazes;
  [[nodiscard]] bool empty() const { return !(near < far); }
  [[nodiscard]] bool unclear() const { return grazes || std::abs(far - near) <= near_slack + far_slack; }
};

BoxSurface::BoxSurface(const Box& box, const Transform& world_from_box, std::uint16_t object)
    : box_(box), box_from_world_(world_from_box.inverse()), object_(object) {
  for (int i = 0; i < 8; ++i) bounds_.add(world_from_box.point(box.corner(i)));
}

BoxSurface::Chord BoxSurface::chord(const RayStream& rays, int i) const {
  constexpr double kRounding = 0x1p-49;
  const Double3 o = {rays.ox[i], rays.oy[i], rays.oz[i]}, d = {rays.dx[i], rays.dy[i], rays.dz[i]};
  Chord chord = {-Box::inf, Box::inf, 0, 0, false};
  for (int a = 0; a < 3; ++a) {
    const double(&row)[4] = box_from_world_.m[a];
    double from = row[3], along = 0, from_size = std::abs(row[3]), along_size = 0;
    for (int c = 0; c < 3; ++c) {
      from += row[c] * o[c], along += row[c] * d[c];
      from_size += std::abs(row[c] * o[c]), along_size += std::abs(row[c] * d[c]);
    }
    if (std::abs(along) <= kRounding * along_size) {  // along the faces
      const double margin = kRounding * from_size;
      if (from < box_.lo[a] - margin || from > box_.hi[a] + margin) return {1, 0, 0, 0, false};
      chord.grazes = chord.grazes || from < box_.lo[a] + margin || from > box_.hi[a] - margin;
      continue;
    }
    const auto face = [&](double at, double& slack) {
      const double t = (at - from) / along;
      slack = kRounding *
              ((std::abs(at) + from_size) / std::abs(along) + std::abs(t) * along_size / std::abs(along));
      return t;
    };
    double lo_slack = 0, hi_slack = 0;
    double lo = face(box_.lo[a], lo_slack), hi = face(box_.hi[a], hi_slack);
    if (along < 0) std::swap(lo, hi), std::swap(lo_slack, hi_slack);
    if (lo > chord.near) chord.near = lo, chord.near_slack = lo_slack;
    if (hi < chord.far) chord.far = hi, chord.far_slack = hi_slack;
  }
  return chord;
}

// Where the ray comes in or, `leaves`, goes out.
void BoxSurface::write(const Chord& chord, bool leaves, int i, HitStream& hits) const {
  const double t = leaves ? chord.far : chord.near, slack = leaves ? chord.far_slack : chord.near_slack;
  hits.t[i] = t, hits.t_lo[i] = t - slack, hits.t_hi[i] = t + slack;
  hits.sides[i] = leaves;
  hits.iso[i] = 0;
  hits.object[i] = object_;
  hits.certificate[i] = chord.unclear() ? Certificate::undecided : Certificate::proved_hit;
}

void BoxSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& /*counts*/) const {
  for (int i = 0; i < rays.size; ++i) {
    const double begin = rays.t_min[i], end = std::min(rays.t_max[i], hits.t[i]);
    if (begin > end) continue;
    Chord chord = this->chord(rays, i);
    if (chord.empty()) {
      if (chord.unclear()) hits.certificate[i] = Certificate::undecided;
      continue;
    }
    bool inside = chord.near < begin;
    if (rays.start_object[i] == object_) {  // on the face that is nearer, of which the side is known
      inside = rays.start_sides[i] & 1;
      if (inside) chord.far = std::max(chord.far, begin);
      else if (begin > 0.5 * (chord.near + chord.far)) continue;
      else chord.near = std::max(chord.near, begin);
    }
    const double t = inside ? chord.far : chord.near;
    if (t >= begin && t <= end && t < hits.t[i]) write(chord, inside, i, hits);
  }
}

void BoxSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& /*counts*/) const {
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != object_ || !is_hit(hits, i)) continue;
    const bool was_outside = !(hits.sides[i] & 1);
    hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = Box::inf;
    const Chord chord = this->chord(rays, i);
    if (was_outside && chord.far <= rays.t_max[i]) write(chord, true, i, hits);
  }
}

void BoxSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                       DressedHits& dressed) const {
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != object_ || !is_hit(hits, i)) continue;
    const Double3 o = {rays.ox[i], rays.oy[i], rays.oz[i]}, d = {rays.dx[i], rays.dy[i], rays.dz[i]},
                  p = o + hits.t[i] * d;
    if (wishes.position)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = p[a];
    if (wishes.value) dressed.value[i] = 0;
    if (!wishes.normal) continue;
    const Double3 in_box = box_from_world_.point(p);
    const auto beyond = [&](int a) {
      const double half = 0.5 * (box_.hi[a] - box_.lo[a]);
      return std::abs(in_box[a] - box_.lo[a] - half) / half;
    };
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (beyond(a) > beyond(axis)) axis = a;
    Double3 across = {0, 0, 0};
    across[axis] = 1;
    const Double3 normal = normalized(box_from_world_.transposed_vector(across));
    const double turn = dot(normal, d) > 0 ? -1 : 1;
    for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
  }
}

}  // namespace isocast
