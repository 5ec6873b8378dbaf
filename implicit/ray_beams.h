// The rays of a tile are cut together to where f may be an iso-value, before each is solved.
#pragma once

#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/solve/kernels.h>

namespace isocast {

/// Narrows [near, far] of the rays, packet by packet, to what holds all their roots, with a little behind the
/// last; a ray that has none then misses. Does nothing where the rays do not run along one axis.
///
/// rays       `size` of them, at most kStreamSize; those that miss are left alone
/// registers  as the solver's
/// returns    the evaluations that it took
template <class T>
std::int64_t narrow_rays(const FormulaQuery<T>& query, const FormulaSolver<T>& solver, ClippedRay* rays,
                         int size, void* registers);

}  // namespace isocast
