// Rays of a patch as columns in registers.
#pragma once

#include <isocast/volume/columns.h>
#include <isocast/volume/primary/patch.h>

namespace isocast::inline ISO_ISA {

/// The members of as many rays as a register has lanes, one a lane.
template <Real R> struct RayColumns { R own[3], other[3], depth, axis; };

template <Real R> inline RayColumns<R> load_rays(const PatchRay* rays, const std::int32_t* numbers) {
  const Columns<R> c =
      load_columns<R>([&](int l) { return reinterpret_cast<const double*>(rays + numbers[l]); });
  return {{c.v[0], c.v[1], c.v[2]}, {c.v[3], c.v[4], c.v[5]}, c.v[6], c.v[7]};
}

template <Real R> inline void store_rays(const RayColumns<R>& c, PatchRay* rays) {
  store_columns<R>({{c.own[0], c.own[1], c.own[2], c.other[0], c.other[1], c.other[2], c.depth, c.axis}},
                   [&](int l) { return reinterpret_cast<double*>(rays + l); });
}

}  // namespace isocast::inline ISO_ISA
