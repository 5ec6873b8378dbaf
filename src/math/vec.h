// Three Reals.
#pragma once

#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

template <Real R> struct Vec3 { R x, y, z; };
/// (1-t) a + t b, component by component.
template <Real R> ISO_HD inline Vec3<R> lerp(const Vec3<R>& a, const Vec3<R>& b, R t) {
  return {lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)};
}

}  // namespace isocast::inline ISO_ISA
