// From a dressed hit to a colour.
#pragma once

#include <isocast/render/kernels.h>
#include <isocast/render/shadows.h>

namespace isocast {

/// Blinn and Phong's model, in two parts: 15 % ambient; of each white light 75 % diffuse and the
/// material's highlight. All vectors have unit length: `normal` faces the viewer, `to_light` and `to_eye`
/// point away from the surface.
[[nodiscard]] Color ambient(const Color& surface);
[[nodiscard]] Color lit(const Material& surface, const Double3& normal, const Double3& to_light,
                        const Double3& to_eye);

/// Those of a wave's hits, with the colours of their objects' fields where there are some.
void find_surfaces(const Frame& frame, const Wave& wave, LitSurfaces& surfaces);

/// The colour of every hit of a wave, without what it mirrors. n lights have 1/n of the strength each, so
/// that they never overexpose together; without lights a headlight shines along every ray. Ambient occlusion
/// is a light from everywhere, and dims the ambient part as well.
void shade(const Frame& frame, const Wave& wave, Shadows& shadows, Color (&colors)[kStreamSize],
           RenderCounts& counts);

}  // namespace isocast
