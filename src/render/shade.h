// From a dressed hit to a colour.
#pragma once

#include <isocast/scene/scene.h>

namespace isocast {

/// Blinn and Phong's model with one white light: 15 % ambient, 75 % diffuse, a weak highlight. All vectors
/// have unit length: `normal` faces the viewer, `to_light` and `to_eye` point away from the surface. `lit`
/// false: in shadow, ambient only.
[[nodiscard]] Color shade(const Color& surface, const Double3& normal, const Double3& to_light,
                          const Double3& to_eye, bool lit);

}  // namespace isocast
