// The options that say what is seen and from where, the same for every verb that traces rays.
#pragma once

#include <isocast/apps/isocast/render_words.h>

namespace CLI {
class App;
}

namespace isocast {

/// Adds INPUT, the iso-values, what a formula and a raw file need, the method with its settings, the size
/// and the camera to a verb; parsing fills `words`, which must live until then.
///
/// method  what --method may say, for --help
void add_scene_options(CLI::App& verb, RenderWords& words, const char* method);

}  // namespace isocast
