// Which hits see a light.
#pragma once

#include <isocast/render/crossings.h>

namespace isocast {

/// Rays from hits towards light. Objects that are not opaque let through what the eye would see through
/// them.
class Shadows {
 public:
  /// visible[i]: the share of the light, 0 to 1, that reaches hit i of the wave. Hits that face away from it
  /// keep 1: no light falls on them anyway.
  void trace(const Frame& frame, const Wave& wave, const Double3& to_light, float (&visible)[kStreamSize],
             RenderCounts& counts);

  /// open[i]: the share of the light from everywhere (AmbientOcclusion), weighted by the cosine of its
  /// angle, that reaches hit i; 1 where there is no normal. The directions depend on the pixel and the sample
  /// alone.
  void look_around(const Frame& frame, const Wave& wave, float (&open)[kStreamSize], RenderCounts& counts);

 private:
  void pass(const Frame& frame, RenderCounts& counts);
  void pass_layers(const Frame& frame, RenderCounts& counts);

  RayStream rays_;
  HitStream hits_;
  Crossings crossings_;
  std::vector<std::uint16_t> candidates_;
  int hit_of_[kStreamSize];  // per shadow ray
  float passed_[kStreamSize];
};

}  // namespace isocast
