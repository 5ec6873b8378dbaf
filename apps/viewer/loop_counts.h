// What the render loop has done, for --stats and the tests.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace isocast::viewer {

/// Written by the render thread, read by any.
///
/// pictures            by stage
/// tiles_rendered      of all pictures, tiles_cancelled: of pictures that were ended, those not begun
/// cancelled           pictures that were ended, and of these: tiles that were still finished after the end
///                     was wanted, at most (no more than threads), and the longest time that took
/// late_previews       that took longer than their budget
struct LoopCounts {
  std::array<std::atomic<std::int64_t>, 4> pictures = {};
  std::atomic<std::int64_t> tiles_rendered = 0, tiles_cancelled = 0, cancelled = 0, late_previews = 0;
  std::atomic<std::int64_t> tiles_after_end = 0;
  std::atomic<double> longest_end_ms = 0, longest_preview_ms = 0;
  std::atomic<std::int64_t> scenes = 0;
};

}  // namespace isocast::viewer
