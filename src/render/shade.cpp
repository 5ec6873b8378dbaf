#include <isocast/render/kernels.h>
#include <isocast/render/lighting.h>
#include <isocast/render/shade.h>

#include <algorithm>

namespace isocast {

namespace {

Vec3<double> vec(const Double3& v) { return {v[0], v[1], v[2]}; }

constexpr float kAmbient = 0.15f;

bool has_one_material(const Scene& scene) {
  return scene.objects.size() == 1 && scene.objects.front().materials.size() == 1;
}

void put(const Material& material, int i, LitSurfaces& surfaces) {
  for (int c = 0; c < 3; ++c) surfaces.color[c][i] = material.color[c];
  surfaces.specular[i] = material.specular;
}

}  // namespace

Color ambient(const Color& surface) {
  return {kAmbient * surface[0], kAmbient * surface[1], kAmbient * surface[2]};
}

Color lit(const Material& surface, const Double3& normal, const Double3& to_light, const Double3& to_eye) {
  const auto [facing, highlight] = incidence(vec(normal), vec(to_light), vec(to_eye));
  Color color;
  for (int c = 0; c < 3; ++c)
    color[c] =
        lit(surface.color[c], surface.specular, static_cast<float>(facing), static_cast<float>(highlight));
  return color;
}

void find_surfaces(const Frame& frame, const Wave& wave, LitSurfaces& surfaces) {
  const HitStream& hits = *wave.hits;
  const bool one = has_one_material(frame.scene);
  for (int i = 0; i < wave.rays.size; ++i)
    if (one) put(frame.scene.objects.front().materials.front(), i, surfaces);
    else if (is_hit(hits, i)) put(material_of(frame.scene, hits, i), i, surfaces);
  if (!frame.features.color_fields) return;

  std::vector<std::uint16_t> objects;
  ObjectHierarchy::find_hit_objects(wave.rays.size, hits, objects);
  for (const std::uint16_t object : objects) {
    const ColorField* const field = frame.scene.objects[object].color_field.get();
    if (!field) continue;
    Double3 points[kStreamSize];
    Color colors[kStreamSize];
    int slots[kStreamSize];
    std::size_t count = 0;
    for (int i = 0; i < wave.rays.size; ++i) {
      if (!is_hit(hits, i) || hits.object[i] != object) continue;
      const RayStream& rays = wave.rays;
      points[count] = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + hits.t[i] * direction_of(rays, i);
      slots[count++] = i;
    }
    field->find_colors({points, count}, {colors, count});
    for (std::size_t k = 0; k < count; ++k)
      for (int c = 0; c < 3; ++c) surfaces.color[c][slots[k]] = colors[k][c];
  }
}

void shade(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
           RenderCounts& counts) {
  const int size = wave.rays.size;
  LitSurfaces surfaces;
  find_surfaces(frame, wave, surfaces);
  float sum[3][kStreamSize];
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < size; ++i) sum[c][i] = kAmbient * surfaces.color[c][i];

  const bool around = frame.features.occlusion > 0;
  const std::size_t lights = around ? frame.lights.size() : std::max<std::size_t>(1, frame.lights.size());
  const float strength = 1 / static_cast<float>(lights + (around ? 1 : 0));
  float visible[kStreamSize];
  if (around) {
    shadows.look_around(frame, wave, visible, counts);
    for (int i = 0; i < size; ++i) {
      if (!is_hit(*wave.hits, i)) continue;
      for (int c = 0; c < 3; ++c)
        sum[c][i] = visible[i] * (sum[c][i] + strength * lit(surfaces.color[c][i], 0.0f, 1.0f, 0.0f));
    }
  }
  std::ranges::fill(visible, 1.0f);
  FallingLight light;
  const RenderKernels& kernels = render_kernels();
  for (std::size_t l = 0; l < lights; ++l) {
    if (frame.features.shadows) shadows.trace(frame, wave, frame.lights[l], visible, counts);
    const double* to_light = frame.lights.empty() ? nullptr : frame.lights[l].data();
    kernels.light(wave.rays, *wave.hits, wave.dressed.normal, to_light, light);
    kernels.add_light(surfaces, light, strength, visible, size, sum);
  }
  for (int i = 0; i < size; ++i)
    if (is_hit(*wave.hits, i)) colors[i] = {sum[0][i], sum[1][i], sum[2][i]};
}

}  // namespace isocast
