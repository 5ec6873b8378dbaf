#include <isocast/render/kernels.h>
#include <isocast/render/lighting.h>
#include <isocast/render/shade.h>

#include <algorithm>

namespace isocast {

namespace {

Vec3<double> vec(const Double3& v) { return {v[0], v[1], v[2]}; }

Color lit(const Material& surface, double facing, double highlight) {
  constexpr float kDiffuse = 0.75f;
  Color color;
  for (int c = 0; c < 3; ++c)
    color[c] = kDiffuse * static_cast<float>(facing) * surface.color[c] +
               surface.specular * static_cast<float>(highlight);
  return color;
}

}  // namespace

Color ambient(const Color& surface) {
  constexpr float kAmbient = 0.15f;
  return {kAmbient * surface[0], kAmbient * surface[1], kAmbient * surface[2]};
}

Color lit(const Material& surface, const Double3& normal, const Double3& to_light, const Double3& to_eye) {
  const auto [facing, highlight] = incidence(vec(normal), vec(to_light), vec(to_eye));
  return lit(surface, facing, highlight);
}

void find_materials(const Frame& frame, const Wave& wave, Material (&materials)[kStreamSize]) {
  const HitStream& hits = *wave.hits;
  for (int i = 0; i < wave.rays.size; ++i)
    if (is_hit(hits, i)) materials[i] = material_of(frame.scene, hits, i);
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
    for (std::size_t k = 0; k < count; ++k) materials[slots[k]].color = colors[k];
  }
}

void shade(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
           RenderCounts& counts) {
  Material materials[kStreamSize];
  find_materials(frame, wave, materials);
  const auto surface = [&](int i) -> const Material& { return materials[i]; };
  for (int i = 0; i < wave.rays.size; ++i)
    if (is_hit(*wave.hits, i)) colors[i] = ambient(surface(i).color);

  const bool around = frame.features.occlusion > 0;
  const std::size_t lights = around ? frame.lights.size() : std::max<std::size_t>(1, frame.lights.size());
  const float strength = 1 / static_cast<float>(lights + (around ? 1 : 0));
  float visible[kStreamSize];
  if (around) {
    shadows.look_around(frame, wave, visible, counts);
    for (int i = 0; i < wave.rays.size; ++i) {
      if (!is_hit(*wave.hits, i)) continue;
      const Color light = lit(surface(i), 1, 0);
      for (int c = 0; c < 3; ++c) colors[i][c] = visible[i] * (colors[i][c] + strength * light[c]);
    }
  }
  std::ranges::fill(visible, 1.0f);
  double facing[kStreamSize], highlight[kStreamSize];
  for (std::size_t l = 0; l < lights; ++l) {
    if (frame.features.shadows) shadows.trace(frame, wave, frame.lights[l], visible, counts);
    const double* to_light = frame.lights.empty() ? nullptr : frame.lights[l].data();
    render_kernels().light(wave.rays, *wave.hits, wave.dressed.normal, to_light, facing, highlight);
    for (int i = 0; i < wave.rays.size; ++i) {
      if (!is_hit(*wave.hits, i)) continue;
      const Color light = lit(surface(i), facing[i], highlight[i]);
      for (int c = 0; c < 3; ++c) colors[i][c] += strength * visible[i] * light[c];
    }
  }
}

}  // namespace isocast
