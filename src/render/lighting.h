// Light on a surface, over any Real.
#pragma once

#include <isocast/math/vec.h>

namespace isocast::inline ISO_ISA {

template <Real R> ISO_HD inline R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// a / |a|; the zero vector stays zero.
template <Real R> ISO_HD inline Vec3<R> unit(const Vec3<R>& a) {
  const R n = sqrt(dot(a, a));
  const Mask<R> some = n > R(0);
  return {select(some, a.x / n, a.x), select(some, a.y / n, a.y), select(some, a.z / n, a.z)};
}

/// cos of the angle of incidence, and cos^32 of that between the normal and the half-way vector; both zero
/// where the surface faces away from the light.
template <Real R> struct Incidence { R facing, highlight; };

/// cos^32 by squaring: the same bits with every library.
template <Real R> ISO_HD inline R highlight_of(R cosine) {
  R highlight = max(cosine, R(0));
  for (int i = 0; i < 5; ++i) highlight = highlight * highlight;
  return highlight;
}

/// All vectors have unit length and point away from the surface.
/// source  Blinn: Models of light reflection for computer synthesized pictures, SIGGRAPH 1977
template <Real R>
ISO_HD inline Incidence<R> incidence(const Vec3<R>& normal, const Vec3<R>& to_light, const Vec3<R>& to_eye) {
  const R facing = dot(normal, to_light);
  const Mask<R> away = facing <= R(0);
  const Vec3<R> half_way =
      unit(Vec3<R>{to_light.x + to_eye.x, to_light.y + to_eye.y, to_light.z + to_eye.z});
  return {select(away, R(0), facing), select(away, R(0), highlight_of(dot(normal, half_way)))};
}
/// The same for a light at the eye, which is half-way to itself.
template <Real R> ISO_HD inline Incidence<R> headlight(const Vec3<R>& normal, const Vec3<R>& to_eye) {
  const R facing = dot(normal, to_eye);
  const Mask<R> away = facing <= R(0);
  return {select(away, R(0), facing), select(away, R(0), highlight_of(facing))};
}

/// 75 % diffuse light of a colour, and the highlight.
template <Real R> ISO_HD inline R lit(R color, R specular, R facing, R highlight) {
  return R(0.75f) * facing * color + specular * highlight;
}

}  // namespace isocast::inline ISO_ISA
