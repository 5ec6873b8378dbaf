#include <isocast/render/shade.h>

#include <algorithm>

namespace isocast {

Color ambient(const Color& surface) {
  constexpr float kAmbient = 0.15f;
  return {kAmbient * surface[0], kAmbient * surface[1], kAmbient * surface[2]};
}

Color lit(const Color& surface, const Double3& normal, const Double3& to_light, const Double3& to_eye) {
  constexpr float kDiffuse = 0.75f, kSpecular = 0.12f;
  const double facing = dot(normal, to_light);
  if (facing <= 0) return {0, 0, 0};
  // cos^32 by squaring: the same bits with every library
  double highlight = std::max(0.0, dot(normal, normalized(to_light + to_eye)));
  for (int i = 0; i < 5; ++i) highlight *= highlight;
  Color color;
  for (int c = 0; c < 3; ++c)
    color[c] = kDiffuse * static_cast<float>(facing) * surface[c] + kSpecular * static_cast<float>(highlight);
  return color;
}

void shade(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
           RenderCounts& counts) {
  const auto surface = [&](int i) { return material_of(frame.scene, wave.hits, i).color; };
  for (int i = 0; i < wave.rays.size; ++i)
    if (is_hit(wave.hits, i)) colors[i] = ambient(surface(i));

  const std::size_t lights = std::max<std::size_t>(1, frame.lights.size());
  const float strength = 1 / static_cast<float>(lights);
  float visible[kStreamSize];
  std::ranges::fill(visible, 1.0f);
  for (std::size_t l = 0; l < lights; ++l) {
    if (frame.features.shadows) shadows.trace(frame, wave, frame.lights[l], visible, counts);
    for (int i = 0; i < wave.rays.size; ++i) {
      if (!is_hit(wave.hits, i)) continue;
      const Double3 to_eye = -1.0 * normalized(direction_of(wave.rays, i));
      const Double3& to_light = frame.lights.empty() ? to_eye : frame.lights[l];
      const Color light = lit(surface(i), normal_of(wave.dressed, i), to_light, to_eye);
      for (int c = 0; c < 3; ++c) colors[i][c] += strength * visible[i] * light[c];
    }
  }
}

}  // namespace isocast
