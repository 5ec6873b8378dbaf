// The primary rays of a view as one map that is linear in each of its arguments.
#pragma once

namespace isocast {

/// The point at depth s along the view axis on the ray through pixel position (u, v), in pixels from the upper
/// left corner: (o + u o_u + v o_v) + s (d + u d_u + v d_v), world space. Perspective: o_u and o_v are zero;
/// orthographic: d_u and d_v are. A camera's rays (View::fill) follow it but for roundings of their unit
/// directions.
struct PixelLines {
  double o[3], o_u[3], o_v[3], d[3], d_u[3], d_v[3];
};

}  // namespace isocast
