// Scenes from text, and the volumes and meshes that they name.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/render/render.h>

#include <fstream>
#include <functional>
#include <string>

namespace isocast::test {

/// f at the points of a grid of n^3 from lo to hi, as an f32 .nrrd.
inline void write_nrrd(const std::filesystem::path& path, int n, double lo, double hi,
                       const std::function<double(double, double, double)>& f) {
  std::ofstream file(path, std::ios::binary);
  const double step = (hi - lo) / (n - 1);
  const std::string space = std::to_string(step);
  file << "NRRD0004\ntype: float\ndimension: 3\nsizes: " << n << ' ' << n << ' ' << n
       << "\nspace dimension: 3\nspace directions: (" << space << ",0,0) (0," << space << ",0) (0,0," << space
       << ")\nspace origin: (" << lo << ',' << lo << ',' << lo << ")\nendian: little\nencoding: raw\n\n";
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const auto value = static_cast<float>(f(lo + step * x, lo + step * y, lo + step * z));
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
      }
}

/// A scene of these objects, built.
inline BuiltScene built(const std::string& objects, const std::filesystem::path& folder = {}) {
  return build_scene(scene_from_text(R"({"isocast": 1, "objects": [)" + objects + "]}", "test", folder), {});
}

/// Looks at a point along -z or from the side; ortho: height of the picture, 0 for perspective.
inline View looking(const Scene& scene, const Double3& from, const Double3& at, int pixels,
                    double ortho = 0) {
  CameraWishes wishes;
  wishes.position = from, wishes.target = at, wishes.up = Double3{0, 1, 0};
  if (ortho > 0) wishes.ortho_height = ortho;
  return {frame(scene.bounds(), wishes, 1), pixels, pixels};
}

/// What a ray hits first: t, +inf where nothing, and the object.
struct OneHit {
  double t;
  int object;
};
inline OneHit first_hit(const Scene& scene, const Double3& o, const Double3& d) {
  const auto rays = std::make_unique<RayStream>();
  rays->size = 1;
  rays->kind = RayKind::reflection;
  rays->ox[0] = o[0], rays->oy[0] = o[1], rays->oz[0] = o[2];
  rays->dx[0] = d[0], rays->dy[0] = d[1], rays->dz[0] = d[2];
  rays->t_min[0] = 0, rays->t_max[0] = Box::inf;
  rays->start_object[0] = kNoObject, rays->start_sides[0] = 0, rays->id[0] = 0;
  const auto hits = std::make_unique<HitStream>();
  clear(*hits);
  TraceCounts counts;
  for (const SceneObject& object : scene.objects) object.surface->first_hit(*rays, *hits, counts);
  return {hits->t[0], hits->object[0]};
}

}  // namespace isocast::test
