// The ray through the centre of a pixel, for what is found out about it.
#pragma once

#include <isocast/apps/scene_build/description.h>
#include <isocast/render/camera.h>

namespace isocast::viewer {

/// o + t d; world space: d has unit length.
struct PixelRay {
  Double3 o, d;
};

[[nodiscard]] PixelRay pixel_ray(const View& view, int x, int y);

/// The same points by the same t where the object's reference takes its rays: formulas in their own space,
/// volumes in the world's.
[[nodiscard]] PixelRay reference_ray(const PixelRay& ray, const ObjectDescription& object);

}  // namespace isocast::viewer
