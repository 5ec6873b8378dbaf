// The table of what a frame does for many rays at once, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// A picture as primary rays see it: the pixel (u, v) lies at corner + u right + v down (perspective:
/// relative to the eye), and `fixed` is the direction of all rays (orthographic) or the eye.
struct RayFrame {
  double corner[3], right[3], down[3], fixed[3];
  int width, height;
  bool orthographic;
};

/// fill_rays  View::fill
/// light      for the hits: the cosine of the angle of incidence, and the highlight (incidence in
/// lighting.h).
///            to_light: the direction towards the light, or null for a headlight. Slots without a hit hold no
///            meaning
struct RenderKernels {
  void (*fill_rays)(const RayFrame& frame, int tx, int ty, double offset_u, double offset_v, RayStream& rays);
  void (*light)(const RayStream& rays, const HitStream& hits, const double (&normal)[3][kStreamSize],
                const double* to_light, double (&facing)[kStreamSize], double (&highlight)[kStreamSize]);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const RenderKernels& render_kernels(Isa isa);
/// That of the widest.
[[nodiscard]] const RenderKernels& render_kernels();

}  // namespace isocast
