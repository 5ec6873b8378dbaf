// Where the rays of a row of pixels are in the domain.
#pragma once

#include <isocast/implicit/frustum/block_query.h>
#include <isocast/math/pack.h>
#include <isocast/math/rounding.h>

namespace isocast::inline ISO_ISA {

/// Depths, begin < end, between which the rays of 16 pixels from u on in the row at v are in the domain and
/// in the depths of the query; begin >= end where they are not. lengths: world lengths of depth 1.
inline void clip_row(const FrustumQuery& query, double u, double v, double* begin, double* end,
                     double* lengths) {
  using W = Native<double>;
  const PixelLines& lines = query.lines;
  for (int first = 0; first < 16; first += kWidth<W>) {
    double places[kWidth<W>];
    for (int l = 0; l < kWidth<W>; ++l) places[l] = u + (first + l) + query.offset_u;
    const W pixel = load<W>(places);
    W near = W(query.s0), far = W(query.s1), squared = W(0.0);
    for (int a = 0; a < 3; ++a) {
      const W o = W(lines.o[a] + v * lines.o_v[a]) + pixel * W(lines.o_u[a]),
              d = W(lines.d[a] + v * lines.d_v[a]) + pixel * W(lines.d_u[a]);
      const W way = W(1.0) / d, t0 = (W(query.lo[a]) - o) * way, t1 = (W(query.hi[a]) - o) * way;
      const Mask<W> still = !(abs(way) < W(kInfinity<double>));
      const Mask<W> outside = still & ((o < W(query.lo[a])) | (o > W(query.hi[a])));
      squared = squared + d * d;
      near = select(still, near, max(min(t0, t1), near));
      far = select(still, select(outside, W(-kInfinity<double>), far), min(max(t0, t1), far));
    }
    store(begin + first, near);
    store(end + first, far);
    store(lengths + first, sqrt(squared));
  }
}

}  // namespace isocast::inline ISO_ISA
