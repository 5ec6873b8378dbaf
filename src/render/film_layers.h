// The layers of the film, from the first hits.
#pragma once

#include <isocast/render/frame.h>

namespace isocast {

/// Writes the layers of a tile's primary rays and counts hits, misses and what is undecided.
void write_layers(const Frame& frame, const Wave& wave, Film& film, RenderCounts& counts);

}  // namespace isocast
