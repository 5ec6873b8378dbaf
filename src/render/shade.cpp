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

void shade(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
           RenderCounts& counts) {
  const auto surface = [&](int i) { return material_of(frame.scene, *wave.hits, i); };
  for (int i = 0; i < wave.rays.size; ++i)
    if (is_hit(*wave.hits, i)) colors[i] = ambient(surface(i).color);

  const std::size_t lights = std::max<std::size_t>(1, frame.lights.size());
  const float strength = 1 / static_cast<float>(lights);
  float visible[kStreamSize];
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
