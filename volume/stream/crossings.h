// Crossings of planes for several rays at once: the same expressions and the same order as the walk
// (traverse.h).
#pragma once

#include <isocast/math/pack.h>
#include <isocast/volume/traverse.h>

namespace isocast::inline ISO_ISA {

/// The largest whole numbers that are not above, for |v| < 2^51.
template <Real R> inline R whole(R v) { return floor(v); }
#ifdef __AVX512DQ__
template <> inline Pack<double, 8> whole(Pack<double, 8> v) {
  return Pack<double, 8>(_mm512_maskz_roundscale_pd(0xff, v.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
}
#endif

/// One axis of several rays.
template <Real R> struct AxisOfRays {
  R o, d, inverse;
  Mask<R> back, moves;
  R far, near;  // 1 and 0 forwards, 0 and 1 backwards: from a cell's number to those of its planes

  AxisOfRays(R o, R d, R inverse)
      : o(o), d(d), inverse(inverse), back(inverse < R(0)), moves(abs(inverse) < R(__builtin_inf())) {
    far = select(back, R(0), R(1));
    near = R(1) - far;
  }

  /// Where they meet plane k; +inf where they are parallel to it.
  R plane_t(R k) const { return select(moves, (k - o) * inverse, R(__builtin_inf())); }
};

/// The crossing of plane (t, a) comes before that of (t0, a0), or is it.
template <Real R> Mask<R> crossed(R t, int a, R t0, R a0) {
  return (t < t0) | ((t == t0) & (R(double(a)) <= a0));
}

/// The cells between lo and hi, both included, that the rays of `valid` are in along axis a after all
/// crossings up to (t, axis).
template <Real R> R cell_after(const AxisOfRays<R>& ray, int a, R t, R axis, R lo, R hi, Mask<R> valid) {
  R cell = min(max(whole(ray.o + t * ray.d), lo), hi);
  const R ahead = select(ray.back, lo, hi), behind = select(ray.back, hi, lo), forwards = ray.far - ray.near;
  const Mask<R> moving = valid & ray.moves;
  for (;;) {
    const Mask<R> on = moving & (cell != ahead) & crossed(ray.plane_t(cell + ray.far), a, t, axis),
                  over = moving & (cell != behind) & !crossed(ray.plane_t(cell + ray.near), a, t, axis);
    if (!any(on | over)) return cell;
    cell = cell + select(on, forwards, select(over, -forwards, R(0)));
  }
}

/// The cells that rays keep to along an axis that they are parallel to: on a plane, the one that d points
/// into.
template <Real R> R parallel_cell(const AxisOfRays<R>& ray, R lo, R hi) {
  const R cell = min(max(floor(ray.o), lo), hi);
  return select((ray.d < R(0)) & (cell > lo) & (cell >= ray.o), cell - R(1), cell);
}

}  // namespace isocast::inline ISO_ISA
