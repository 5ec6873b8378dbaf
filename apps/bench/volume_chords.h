// The cells of a volume that a picture's rays have to be intersected with.
#pragma once

#include <isocast/apps/bench/cell_case.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/ray/stream.h>

namespace isocast::bench {

/// Of every ray the cells whose corners lie on both sides of the iso-value, up to the one with the first
/// crossing: what a traversal hands to an intersector. Rounded to float; of rays up to the one that makes
/// them `most`.
/// Throws InputError unless the scene is a volume with one iso-value.
[[nodiscard]] CellCase volume_chords(const BuiltScene& built, const std::vector<RayStream>& rays,
                                     std::size_t most);

}  // namespace isocast::bench
