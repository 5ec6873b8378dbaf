// The frames of a command line.
#pragma once

#include <isocast/apps/isocast/render_words.h>

#include <string>

namespace isocast {

/// Renders every frame that the words ask for, with its file, --stats and manifest; with --resume those that
/// are not there yet. Throws InputError, and Interrupted after Ctrl-C: then whole frames are left.
///
/// version  the program's
void render_frames(const RenderWords& words, const std::string& version);

}  // namespace isocast
