// Colours that depend on the place.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/scene/material.h>

#include <span>

namespace isocast {

/// Calls are const and may come from any thread.
class ColorField {
 public:
  virtual ~ColorField() = default;

  /// The colours of points of the world, as many as there are.
  virtual void find_colors(std::span<const Double3> points, std::span<Color> colors) const = 0;
};

}  // namespace isocast
