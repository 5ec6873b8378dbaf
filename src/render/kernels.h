// The table of what a frame does for many rays at once, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/render/primary_ray.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// What of a stream's hits light falls on, slot by slot. Slots without a hit hold no meaning.
struct alignas(64) LitSurfaces {
  float color[3][kStreamSize], specular[kStreamSize];
};

/// Light as the hits of a stream receive it: the cosine of the angle of incidence, and the highlight
/// (lighting.h).
struct alignas(64) FallingLight {
  float facing[kStreamSize], highlight[kStreamSize];
};

/// fill_rays  View::fill
/// light      for the hits. to_light: the direction towards the light, or null for a headlight. Slots without
///            a hit hold no meaning
/// add_light  adds to the colours of the first `size` slots what a light of this strength makes of them.
///            visible: the share of it that arrives
struct RenderKernels {
  void (*fill_rays)(const RayFrame& frame, int tx, int ty, double offset_u, double offset_v, RayStream& rays);
  void (*light)(const RayStream& rays, const HitStream& hits, const double (&normal)[3][kStreamSize],
                const double* to_light, FallingLight& light);
  void (*add_light)(const LitSurfaces& surfaces, const FallingLight& light, float strength,
                    const float (&visible)[kStreamSize], int size, float (&colors)[3][kStreamSize]);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const RenderKernels& render_kernels(Isa isa);
/// That of the widest.
[[nodiscard]] const RenderKernels& render_kernels();

}  // namespace isocast
