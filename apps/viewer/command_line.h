// The command line that makes a picture, as text to copy.
#pragma once

#include <isocast/apps/isocast/render_words.h>

#include <string>

namespace isocast::viewer {

/// `isocast render ...` with everything that differs from the defaults, words quoted for a POSIX shell.
[[nodiscard]] std::string command_line(const RenderWords& words, const std::string& output);

}  // namespace isocast::viewer
