// Rays of a patch as rows in memory and as columns in registers.
#pragma once

#include <isocast/math/pack.h>
#include <isocast/volume/primary/patch.h>

namespace isocast::inline ISO_ISA {

/// The members of as many rays as a register has lanes, one a lane.
template <Real R> struct RayColumns { R own[3], other[3], depth, axis; };

#ifdef __AVX512DQ__

/// Rows of eight numbers become columns.
inline void transpose(__m512d (&v)[8]) {
  __m512d pairs[8], halves[8];
  for (int i = 0; i < 8; i += 2) {
    pairs[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pairs[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  // each pair of numbers is one now: columns k, k + 2, k + 4 and k + 6 of two rows
  const auto split = [](__m512d a, __m512d b, __m512d& even, __m512d& odd) {
    even = __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13);
    odd = __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15);
  };
  for (int k = 0; k < 2; ++k) {
    split(pairs[k], pairs[k + 2], halves[k], halves[k + 2]);
    split(pairs[k + 4], pairs[k + 6], halves[k + 4], halves[k + 6]);
  }
  for (int k = 0; k < 4; ++k) split(halves[k], halves[k + 4], v[k], v[k + 4]);
}

template <Real R> inline RayColumns<R> load_rays(const PatchRay* rays, const std::int32_t* numbers) {
  __m512d v[8];
  for (int l = 0; l < 8; ++l) v[l] = _mm512_load_pd(rays[numbers[l]].own);
  transpose(v);
  return {{R(v[0]), R(v[1]), R(v[2])}, {R(v[3]), R(v[4]), R(v[5])}, R(v[6]), R(v[7])};
}

template <Real R> inline void store_rays(const RayColumns<R>& c, PatchRay* rays) {
  __m512d v[8] = {c.own[0].v,   c.own[1].v,   c.own[2].v, c.other[0].v,
                  c.other[1].v, c.other[2].v, c.depth.v,  c.axis.v};
  transpose(v);
  for (int l = 0; l < 8; ++l) _mm512_store_pd(rays[l].own, v[l]);
}

#else

template <Real R> inline RayColumns<R> load_rays(const PatchRay* rays, const std::int32_t* numbers) {
  double own[3][kWidth<R>], other[3][kWidth<R>], depth[kWidth<R>], axis[kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l) {
    const PatchRay& ray = rays[numbers[l]];
    for (int a = 0; a < 3; ++a) {
      own[a][l] = ray.own[a];
      other[a][l] = ray.other[a];
    }
    depth[l] = ray.depth;
    axis[l] = ray.axis;
  }
  return {{load<R>(own[0]), load<R>(own[1]), load<R>(own[2])},
          {load<R>(other[0]), load<R>(other[1]), load<R>(other[2])},
          load<R>(depth),
          load<R>(axis)};
}

template <Real R> inline void store_rays(const RayColumns<R>& c, PatchRay* rays) {
  double lanes[kWidth<R>];
  const auto put = [&](R v, auto member) {
    store(lanes, v);
    for (int l = 0; l < kWidth<R>; ++l) member(rays[l]) = lanes[l];
  };
  for (int a = 0; a < 3; ++a) {
    put(c.own[a], [&](PatchRay& ray) -> double& { return ray.own[a]; });
    put(c.other[a], [&](PatchRay& ray) -> double& { return ray.other[a]; });
  }
  put(c.depth, [](PatchRay& ray) -> double& { return ray.depth; });
  put(c.axis, [](PatchRay& ray) -> double& { return ray.axis; });
}

#endif

}  // namespace isocast::inline ISO_ISA
