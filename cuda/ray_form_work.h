// What a kernel of rays' own polynomials is given.
#pragma once

#include <isocast/implicit/frustum/ray_query.h>

namespace isocast {

/// Rays of `streams` streams, whose roots it fills. The tape of `query` is only for kernels that interpret
/// it; its tables lie in the memory that the kernel sees.
struct RayFormWork {
  RayFormQuery query;
  const RayFormStream* rays;
  RayFormRoots* roots;
  std::int32_t streams;
};

}  // namespace isocast
