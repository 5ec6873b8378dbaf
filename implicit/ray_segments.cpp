#include <isocast/implicit/ray_segments.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {

ClippedRay clip(const RayStream& rays, int i, const Box& box) {
  ClippedRay ray{{rays.ox[i], rays.oy[i], rays.oz[i]},
                 {rays.dx[i], rays.dy[i], rays.dz[i]},
                 rays.t_min[i],
                 rays.t_max[i]};
  for (int a = 0; a < 3; ++a) {
    if (ray.d[a] == 0) {
      if (!(ray.o[a] >= box.lo[a] && ray.o[a] <= box.hi[a]))
        ray.far = -std::numeric_limits<double>::infinity();
      continue;
    }
    const double t0 = (box.lo[a] - ray.o[a]) / ray.d[a], t1 = (box.hi[a] - ray.o[a]) / ray.d[a];
    ray.near = std::max(ray.near, std::min(t0, t1));
    ray.far = std::min(ray.far, std::max(t0, t1));
  }
  return ray;
}

template <class T> void set_segment(SegmentStream<T>& segments, int i, const ClippedRay& ray, double eps) {
  double squared = 0;
  for (int a = 0; a < 3; ++a) {
    // doubles and what their roundings make: the true start and span lie within the radius
    const double offset = ray.near * ray.d[a], start = ray.o[a] + offset,
                 span = (ray.far - ray.near) * ray.d[a];
    const T e_T = segments.e[a][i] = static_cast<T>(start), d_T = segments.d[a][i] = static_cast<T>(span);
    const double radius = 0x1p-51 * (std::abs(offset) + std::abs(start) + std::abs(span)) + 0x1p-1070 +
                          std::abs(start - static_cast<double>(e_T)) +
                          std::abs(span - static_cast<double>(d_T));
    // what RayPart rounds: at most eight times the unit roundoff of |e| + |d|
    const double size = std::abs(static_cast<double>(e_T)) + std::abs(static_cast<double>(d_T));
    const double slack = radius + 5.0 * kSpacing<T> * size + 4.0 * kSmallest<T>;
    segments.slack[a][i] = std::nextafter(static_cast<T>(slack), kInfinity<T>);
    if (!(size <= kLargest<T>)) {
      segments.e[a][i] = segments.d[a][i] = 0;
      segments.slack[a][i] = kInfinity<T>;
    }
    squared += span * span;
  }
  segments.smallest[i] = static_cast<T>(std::min(0x1p100, eps / std::sqrt(squared)));
  segments.k_offset[i] = 0;
  segments.k_scale[i] = 1;
}

template <class T> bool march_together(SegmentStream<T>& segments, int first) {
  const int last = std::min(first + kPacketSize, segments.size);
  double sum[3] = {};
  for (int a = 0; a < 3; ++a)
    for (int i = first; i < last; ++i) sum[a] += segments.active[i] ? double(segments.d[a][i]) : 0;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(sum[a]) > std::abs(sum[axis])) axis = a;
  const double sign = sum[axis] < 0 ? -1 : 1;
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (int i = first; i < last; ++i) {
    if (!segments.active[i]) continue;
    const double e = sign * segments.e[axis][i], d = sign * segments.d[axis][i];
    if (!(d > 0)) return false;
    from = std::min(from, e), to = std::max(to, e + d);
  }
  constexpr double kMostStretched = 1024;
  for (int i = first; i < last; ++i)
    if (segments.active[i] && !(to - from <= kMostStretched * sign * segments.d[axis][i])) return false;
  for (int i = first; i < last; ++i) {
    if (!segments.active[i]) continue;
    const double e = sign * segments.e[axis][i], d = sign * segments.d[axis][i];
    segments.k_offset[i] = static_cast<T>((from - e) / d);
    // a little further, so that rounding does not end the path early
    segments.k_scale[i] = static_cast<T>((to - from) / d * (1 + 4 * kSpacing<T>));
  }
  return true;
}

template void set_segment(SegmentStream<float>&, int, const ClippedRay&, double);
template bool march_together(SegmentStream<float>&, int);
template void set_segment(SegmentStream<double>&, int, const ClippedRay&, double);
template bool march_together(SegmentStream<double>&, int);

}  // namespace isocast
