// Where boxes of the grid appear in the picture, over any Real.
#pragma once

#include <isocast/math/vec.h>

namespace isocast {

/// The grid before a camera. Grid point g has the homogeneous pixel coordinates (X, Y, W) = to_pixel (g, 1):
/// u = X / W, v = Y / W, W > 0 in front of the eye (1 everywhere if orthographic).
///
/// to_eye       perspective: world position relative to the eye; orthographic: the ray parameter of g in row
///              0, nothing in the others
/// cell_radius  half the longest diagonal of a cell in the world
/// unit         a power of two that makes numbers near one of ray parameters: cell_radius becomes 1 to 2
/// eye          perspective: the eye in grid space; orthographic: the direction to it
struct ScreenMap {
  double to_pixel[3][4], to_eye[3][4], cell_radius, unit, eye[3];
  bool orthographic;
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// The pixels u +- du, v +- dv hold all of a box, unless it is not wholly in front of the eye: then anything
/// may (`whole`).
template <Real R> struct Footprint {
  R u, v, du, dv;
  Mask<R> whole;
};

/// Footprint of a box in grid space, `size` long in every direction.
///
/// h      the linear part of to_pixel, by rows X, Y, W
/// X,Y,W  to_pixel of its centre
/// For points p of the box, X - u W is linear, zero at the centre, and at most the sum below; W is at least
/// that of the nearest corner.
template <Real R, class T> ISO_HD inline Footprint<R> footprint(const T (&h)[3][3], R x, R y, R w, T size) {
  const R half = R(T(0.5) * size), one = R(1) / w, u = x * one, v = y * one;
  R du = R(0), dv = R(0), dw = R(0);
  for (int a = 0; a < 3; ++a) {
    const R hw = R(h[2][a]);
    du = du + abs(R(h[0][a]) - u * hw);
    dv = dv + abs(R(h[1][a]) - v * hw);
    dw = dw + abs(hw);
  }
  const R nearest = w - half * dw, scale = half / nearest;
  return {u, v, du * scale, dv * scale, !(nearest > R(T(0x1p-6)) * half * dw)};
}

}  // namespace isocast::inline ISO_ISA
