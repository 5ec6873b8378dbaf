// The table of what a frame does for many rays at once, one per instruction set.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/render/primary_ray.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

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
