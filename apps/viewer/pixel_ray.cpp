#include <isocast/apps/viewer/pixel_ray.h>

namespace isocast::viewer {

PixelRay pixel_ray(const View& view, int x, int y) {
  const PixelLines lines = view.lines();
  PixelRay ray;
  for (int a = 0; a < 3; ++a) {
    ray.o[a] = lines.o[a] + (x + 0.5) * lines.o_u[a] + (y + 0.5) * lines.o_v[a];
    ray.d[a] = lines.d[a] + (x + 0.5) * lines.d_u[a] + (y + 0.5) * lines.d_v[a];
  }
  ray.d = normalized(ray.d);
  return ray;
}

PixelRay reference_ray(const PixelRay& ray, const ObjectDescription& object) {
  if (!std::holds_alternative<FormulaSource>(object.source)) return ray;
  const Transform own_from_world = object.place.inverse();
  return {own_from_world.point(ray.o), own_from_world.vector(ray.d)};
}

}  // namespace isocast::viewer
