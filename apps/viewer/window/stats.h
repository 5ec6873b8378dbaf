// The --stats of the viewer, on exit.
#pragma once

#include <isocast/apps/viewer/window/app.h>

namespace isocast::viewer {

/// One JSON object (docs/viewer.md has its keys).
[[nodiscard]] std::string stats_json(const App& app, int threads);

}  // namespace isocast::viewer
