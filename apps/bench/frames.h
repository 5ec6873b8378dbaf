// Frames of volumes: what a picture of growing volumes costs, stage by stage.
#pragma once

#include <isocast/apps/bench/markup.h>
#include <isocast/apps/bench/rows.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// sizes  samples along the edge of the volumes; beyond 512 of bytes only
struct FrameOptions {
  std::vector<int> sizes = {128, 256, 512};
  int pixels = 1024;
  int repetitions = 5;
};

/// One volume before one camera. Seconds of wall time on one thread, the least of the repetitions:
///
/// frame    with shading by the headlight; moving: with an iso-value that no frame has had before
/// streams  the same frame when its primary rays are traced as all others are; walk: one after the other
/// shadows  the frame with one directional light and hard shadows
/// binning  Surface::primary: bricks are projected and sorted into patches
/// hits     the pass alone, its masks there already
/// solves   what as many packets of the volume's cells take as there were in the frame, and nothing else
struct FrameTimes {
  std::string volume, camera, type;
  int samples = 0;
  bool in_object_order = true;
  double frame = 0, moving = 0, streams = 0, walk = 0, shadows = 0, binning = 0, hits = 0, solves = 0;
  std::int64_t rays = 0, hit_rays = 0, shadow_rays = 0, cells = 0, solved = 0;

  /// What masks cost where all are new.
  [[nodiscard]] double masks() const { return moving > frame ? moving - frame : 0; }
};

/// Test volumes of every size, as f32 and u8, from outside, close up and from inside.
[[nodiscard]] std::vector<FrameTimes> run_frames(const FrameOptions& options);

/// Five rows a frame: method "object order", "new iso-value", "streams", "walk" or "with shadows", setting
/// the camera.
[[nodiscard]] std::vector<Row> rows_of(const std::vector<FrameTimes>& frames);
/// A line per frame, and a header.
[[nodiscard]] std::string frames_csv(const std::vector<FrameTimes>& frames);
/// The same as a table to read.
[[nodiscard]] std::string frames_summary(const std::vector<FrameTimes>& frames);
/// Time per ray over samples along an edge, a line per volume: seen from outside, as bytes, which all sizes
/// have.
[[nodiscard]] std::string frames_plot(const std::vector<FrameTimes>& frames);
/// The plot and a table of all stages as a part of report.html.
void add_frames(Markup& html, const std::vector<FrameTimes>& frames);

}  // namespace isocast::bench
