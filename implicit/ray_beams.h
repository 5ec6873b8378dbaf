// The rays of a tile are cut together to where f may be an iso-value, before each is solved.
#pragma once

#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/solve/kernels.h>

namespace isocast {

/// What is proved of a ray before it is solved. crosses: in [near, far] f crosses iso-value `iso` once, from
/// the sides `sides`, and no other.
struct KnownCrossing {
  bool crosses = false;
  std::uint8_t iso = 0;
  std::uint32_t sides = 0;
};

/// Narrows [near, far] of a tile's rays to what holds their first roots, packet by packet: to a bracket no
/// longer than eps (a world length) where one form proves that all rays of a packet cross, else to what holds
/// all roots and a little behind; a ray that has none then misses. Does nothing where the rays do not run
/// along one axis.
///
/// rays       of `stream`, clipped; those that miss are left alone
/// registers  as the solver's
/// returns    the evaluations that it took
template <class T>
std::int64_t narrow_rays(const FormulaQuery<T>& query, const FormulaSolver<T>& solver,
                         const RayStream& stream, double eps, ClippedRay* rays, KnownCrossing* known,
                         void* registers);

}  // namespace isocast
