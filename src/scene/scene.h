// What is rendered: surfaces with their materials, lights and background.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/surface.h>
#include <isocast/scene/color_field.h>
#include <isocast/scene/environment.h>
#include <isocast/scene/material.h>

#include <memory>
#include <vector>

namespace isocast {

/// One surface and the material of each of its iso-values, or of each of its components. color_field: instead
/// of the materials' colours; null: none.
struct SceneObject {
  std::shared_ptr<const Surface> surface;
  std::vector<Material> materials;
  bool by_component = false;
  std::shared_ptr<const ColorField> color_field = {};
};

/// Light from everywhere, which falls on a hit as far as nothing is within `radius` (world units) of it.
/// samples: rays per hit; 0: there is no such light.
struct AmbientOcclusion {
  int samples = 0;
  double radius = Box::inf;
};

/// lights       directions towards directional lights, world space, any length
/// ambient_occlusion  one light more; without any of them there is a headlight, which shines along every ray
/// shadows      hard shadows of the directional lights (a headlight casts none that the camera sees)
/// environment  what is seen where nothing is hit; none: the background
struct Scene {
  std::vector<SceneObject> objects;
  std::vector<Double3> lights;
  AmbientOcclusion ambient_occlusion;
  bool shadows = false;
  std::shared_ptr<const Environment> environment;
  Color background = {1, 1, 1};

  [[nodiscard]] Color color_towards(const Double3& direction) const {
    return environment ? environment->towards(direction) : background;
  }
  [[nodiscard]] Box bounds() const {
    Box box;
    for (const SceneObject& object : objects) box.add(object.surface->bounds());
    return box;
  }
};

}  // namespace isocast
