// The --stats of a frame.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/render/render.h>

#include <string>

namespace isocast {

/// Everything that --stats tells (interface.md, 'Keys of --stats').
struct FrameReport {
  const BuiltScene& built;
  const Features& features;
  const RenderCounts& counts;
  std::string isa;
  std::string precision;
  int threads, width, height, spp;
  double render_ms, write_ms, total_ms;
};

/// One JSON object. `version` is the program's; memory in units of 10^6 bytes.
[[nodiscard]] std::string stats_json(const FrameReport& report, const std::string& version);

}  // namespace isocast
