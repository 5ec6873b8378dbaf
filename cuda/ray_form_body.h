// A thread finds the first root of one ray's own polynomial: the finders of implicit/frustum with rows of one
// ray.
#pragma once

#include <isocast/cuda/place.h>
#include <isocast/cuda/ray_form_work.h>
#include <isocast/implicit/frustum/ray_roots.h>

namespace isocast::inline ISO_ISA {

static_assert(kRow == 1, "ray_form_body.h is for builds with ISO_ONE_RAY");

/// Registers of the tape that RayForms asks for at a time.
inline constexpr std::size_t kRayFormRegisterBytes = 4 * sizeof(Interval<Wide>);

/// T: the roots' precision. `registers` has room for the tape's; a formula that is compiled in needs one.
template <class T>
ISO_HD inline void solve_ray_form(const RayFormWork& work, const Place& place, void* registers) {
  const std::int64_t stream = place.number() / kStreamSize;
  const int i = int(place.number() % kStreamSize);
  if (stream >= work.streams || i >= work.rays[stream].size) return;
  RayForms<T>(work.query, work.rays[stream], work.roots[stream], registers).solve(i);
}

}  // namespace isocast::inline ISO_ISA
