// Rays of a stream as the segments that formula kernels solve.
#pragma once

#include <isocast/implicit/solve/segment.h>
#include <isocast/math/box.h>

namespace isocast {

/// A ray clipped to a box: p(t) for t in [near, far].
struct ClippedRay {
  Double3 o, d;
  double near, far;
  [[nodiscard]] bool misses() const { return !(near < far); }
};
[[nodiscard]] ClippedRay clip(const RayStream& rays, int i, const Box& box);

/// Segment i of the stream from a clipped ray; parts below eps, a world length, need not be divided.
template <class T> void set_segment(SegmentStream<T>& segments, int i, const ClippedRay& ray, double eps);

/// Sets one path for all rays of the packet that begins at `first`, along the axis that they follow most;
/// false where one of them does not.
template <class T> [[nodiscard]] bool march_together(SegmentStream<T>& segments, int first);

}  // namespace isocast
