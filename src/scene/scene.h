// What is rendered: surfaces with their materials, light and background.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/surface.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace isocast {

/// Linear RGB.
using Color = std::array<float, 3>;

/// One surface and the colour of each of its iso-values.
struct SceneObject {
  std::shared_ptr<const Surface> surface;
  std::vector<Color> colors;
};

/// light     direction towards a directional light, world space, any length; none: a headlight at the camera
/// shadows   hard shadows of the directional light (a headlight casts none that the camera sees)
struct Scene {
  std::vector<SceneObject> objects;
  std::optional<Double3> light;
  bool shadows = false;
  Color background = {1, 1, 1};

  [[nodiscard]] Box bounds() const {
    Box box;
    for (const SceneObject& object : objects) box.add(object.surface->bounds());
    return box;
  }
};

}  // namespace isocast
