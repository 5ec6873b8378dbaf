// Triangles as a ray sees them: in the plane across it.
#pragma once

#include <isocast/math/vec.h>
#include <isocast/ray/stream.h>

namespace isocast {

/// The rays of a packet with the maps from space onto the planes across them. A point p lies at
/// x dot (p - o), y dot (p - o) of its plane, where the ray is the origin, and at t = z dot (p - o). x and y
/// turn counterclockwise as seen by a ray that comes towards the eye, and are scaled by a power of two.
struct ProjectedPacket {
  double o[3][kPacketSize], x[3][kPacketSize], y[3][kPacketSize], z[3][kPacketSize];
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

template <Real R> struct Projected { R x, y; };

/// A corner of a triangle across rays; the same bits for every triangle that has it.
template <Real R>
ISO_HD inline Projected<R> project(const R (&o)[3], const R (&x)[3], const R (&y)[3], const double* corner) {
  const R a = R(corner[0]) - o[0], b = R(corner[1]) - o[1], c = R(corner[2]) - o[2];
  return {a * x[0] + b * x[1] + c * x[2], a * y[0] + b * y[1] + c * y[2]};
}

/// Twice the area of the triangle from the origin to a and b; exactly its negative for b and a.
template <Real R> ISO_HD inline R area(const Projected<R>& a, const Projected<R>& b) {
  return a.x * b.y - a.y * b.x;
}
/// Beyond this the sign of `area` is that of the true number.
template <Real R> ISO_HD inline R area_error(const Projected<R>& a, const Projected<R>& b) {
  return R(0x1p-50) * (abs(a.x * b.y) + abs(a.y * b.x));
}

}  // namespace isocast::inline ISO_ISA
