#include <isocast/render/shade.h>

#include <algorithm>

namespace isocast {

Color shade(const Color& surface, const Double3& normal, const Double3& to_light, const Double3& to_eye,
            bool lit) {
  constexpr float kAmbient = 0.15f, kDiffuse = 0.75f, kSpecular = 0.12f;
  Color color = {kAmbient * surface[0], kAmbient * surface[1], kAmbient * surface[2]};
  const double facing = dot(normal, to_light);
  if (!lit || facing <= 0) return color;
  // cos^32 by squaring: the same bits with every library
  double highlight = std::max(0.0, dot(normal, normalized(to_light + to_eye)));
  for (int i = 0; i < 5; ++i) highlight *= highlight;
  for (int c = 0; c < 3; ++c)
    color[c] +=
        kDiffuse * static_cast<float>(facing) * surface[c] + kSpecular * static_cast<float>(highlight);
  return color;
}

}  // namespace isocast
