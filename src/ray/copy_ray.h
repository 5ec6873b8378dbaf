// One ray of a stream into another.
#pragma once

#include <isocast/ray/stream.h>

namespace isocast {

/// Ray i of `from` as ray k of `to`: where it goes and what it starts on, not the pixel that it belongs to.
inline void copy_ray(const RayStream& from, int i, RayStream& to, int k) {
  to.ox[k] = from.ox[i], to.oy[k] = from.oy[i], to.oz[k] = from.oz[i];
  to.dx[k] = from.dx[i], to.dy[k] = from.dy[i], to.dz[k] = from.dz[i];
  to.t_min[k] = from.t_min[i], to.t_max[k] = from.t_max[i];
  to.start_object[k] = from.start_object[i], to.start_sides[k] = from.start_sides[i];
}

}  // namespace isocast
