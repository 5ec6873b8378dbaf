// What the command line says about a .raw file, the same for every verb that reads volumes.
#pragma once

#include <isocast/volume/io/read_volume.h>

namespace CLI {
class App;
}

namespace isocast {

/// Adds --dims, --type, --endian and --skip to a verb; parsing fills `options`, which must live until then.
void add_read_options(CLI::App& verb, ReadOptions& options);

}  // namespace isocast
