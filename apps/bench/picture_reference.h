// The truth of every pixel of a picture.
#pragma once

#include <isocast/apps/bench/picture_truth.h>

#include <filesystem>

namespace isocast::bench {

/// Without normals. On all cores; answers may come from the cache (reference_cache.h). Stops at Ctrl-C. Rays
/// start at t = 0, and their directions are at least of unit length.
[[nodiscard]] PictureTruth solve_picture(const SceneDescription& scene, const BuiltScene& built,
                                         const std::vector<RayStream>& rays,
                                         const std::filesystem::path& cache,
                                         const reference::ReferenceOptions& options = {});

}  // namespace isocast::bench
