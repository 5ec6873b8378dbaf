// A ray of the camera through a point of the picture, over any Real.
#pragma once

#include <isocast/math/vec.h>

namespace isocast {

/// A picture as primary rays see it: the pixel (u, v) lies at corner + u right + v down (perspective:
/// relative to the eye), and `fixed` is the direction of all rays (orthographic) or the eye.
struct RayFrame {
  double corner[3], right[3], down[3], fixed[3];
  int width, height;
  bool orthographic;
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

template <Real R> struct PrimaryRay { Vec3<R> o, d; };

/// World space; d has unit length. Whoever asks for the same (u, v) gets the same bits.
template <Real R> ISO_HD inline PrimaryRay<R> primary_ray(const RayFrame& frame, R u, R v) {
  const auto at = [&](int a) { return R(frame.corner[a]) + u * R(frame.right[a]) + v * R(frame.down[a]); };
  const Vec3<R> point = {at(0), at(1), at(2)},
                fixed = {R(frame.fixed[0]), R(frame.fixed[1]), R(frame.fixed[2])};
  if (frame.orthographic) return {point, fixed};
  const R scale = R(1) / sqrt(point.x * point.x + point.y * point.y + point.z * point.z);
  return {fixed, {scale * point.x, scale * point.y, scale * point.z}};
}

}  // namespace isocast::inline ISO_ISA
