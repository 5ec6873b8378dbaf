// What a scene needs, found before anything runs: it decides which stages run at all.
#pragma once

#include <isocast/render/film.h>
#include <isocast/render/sampling.h>
#include <isocast/scene/scene.h>

#include <string>
#include <vector>

namespace isocast {

/// How a picture is shaded.
///
/// spp                 samples per pixel
/// filter              how they lie in and around it
/// colors              false: only layers are wanted, nothing is shaded
/// transparency_depth  crossings that a ray passes, at least 1; the last counts as opaque if more follow
/// reflections         how often a ray is mirrored
/// silhouettes         edges of surfaces are found and blended in (silhouettes.h)
/// coverage            pixels are blended by the shares that the surface covers (coverage.h): one object that
/// can tell
///                     them (Surface::coverage), one sample a pixel
struct RenderSettings {
  int spp = 1;
  PixelFilter filter = PixelFilter::box;
  bool colors = true;
  int transparency_depth = 4, reflections = 1;
  bool silhouettes = false, coverage = false;
};

struct Features {
  bool shade = false, shadows = false, transparency = false, silhouettes = false, coverage = false,
       color_fields = false;
  int reflections = 0, occlusion = 0;  // occlusion: rays per hit
  DressWishes first_sample,
      other_samples;  // what the hits of the first sample of a pixel must offer, and of the others
  std::vector<std::string> used, left_out;  // for --stats
};

[[nodiscard]] Features find_features(const Scene& scene, const Film& film, const RenderSettings& settings);

}  // namespace isocast
