// A frame: tiles of rays through the scene onto the film.
#pragma once

#include <isocast/base/progress.h>
#include <isocast/render/camera.h>
#include <isocast/render/features.h>
#include <isocast/render/film.h>
#include <isocast/scene/scene.h>

#include <cstdint>
#include <stop_token>

namespace isocast {

/// What a frame took: rays by kind (transparency: the queries for the crossing behind one), the first
/// samples' hits, work in the surfaces; passes: the objects whose primary rays were found in an order of
/// their own.
struct RenderCounts {
  std::int64_t primary = 0, shadow = 0, occlusion = 0, reflection = 0, transparency = 0;
  std::int64_t hits = 0, misses = 0, undecided = 0;
  std::int64_t tiles = 0, tiles_culled = 0, passes = 0, blended = 0, blended_open = 0;
  TraceCounts trace;
  RenderCounts& operator+=(const RenderCounts& other);
};

/// Renders tile by tile on TBB's threads. The film's bytes do not depend on the number of threads or the
/// order of tiles. Throws Interrupted when `stop` is requested, and InputError when a mapped file has shrunk
/// or coverage cannot be had; the film is then worth nothing. progress may be null; it counts tiles.
RenderCounts render(const Scene& scene, const View& view, const RenderSettings& settings, Film& film,
                    std::stop_token stop = {}, Progress* progress = nullptr);

/// Number of tiles of a view, for Progress.
[[nodiscard]] std::int64_t tile_count(const View& view);

}  // namespace isocast
