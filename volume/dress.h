// Position, normal and value at the hits of a volume.
#pragma once

#include <isocast/ray/surface.h>
#include <isocast/volume/dress_kernels.h>
#include <isocast/volume/volume_surface.h>

namespace isocast {

/// slope, intercept  of the user's units
struct VolumeDressing {
  const VolumeQuery& query;
  const DressKernels& kernels;
  double slope, intercept;
  NormalKind normals;
};

/// Surface::dress for a volume, in double precision.
void dress_volume_hits(const VolumeDressing& dressing, const RayStream& rays, const HitStream& hits,
                       const DressWishes& wishes, DressedHits& dressed);

}  // namespace isocast
