// The frames of a job: which there are, which of them are done here, and the names of their files.
#pragma once

#include <isocast/apps/isocast/render_words.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isocast {

/// The frames that the command line asks for, all of them, by rising number: --iso-sweep numbers them from 0
/// on, --time A:B goes from A to B over them, and --frames A:B says which there are or picks from them. One
/// without any of these. Throws InputError for words that cannot be used together.
///
/// animation  the scene's first and last frame; none: nothing changes by itself from frame to frame
[[nodiscard]] std::vector<FrameJob> frame_jobs(const RenderWords& words,
                                               std::optional<std::array<int, 2>> animation = std::nullopt);

/// Those of shard I of N ("I/N", 1 to N): the I-th, the (I + N)-th and so on. Every frame belongs to one.
[[nodiscard]] std::vector<FrameJob> shard_of(std::vector<FrameJob> jobs, const std::string& shard);

/// Everything that decides the picture of a frame but the content of the files that the words name, as text.
[[nodiscard]] std::string picture_text(const RenderWords& words, const FrameJob& job);

/// The file of a frame. A name with one %d, or %04d for leading zeros, takes the frame's number; of several
/// frames without one they are NAME_0000.EXT, NAME_0001.EXT and so on. `%%` is a percent sign. Throws
/// InputError for any other use of %.
[[nodiscard]] std::filesystem::path frame_path(const std::string& pattern, int number, bool several);

}  // namespace isocast
