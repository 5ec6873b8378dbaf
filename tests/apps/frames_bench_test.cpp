// The suite of frames: all volumes and cameras, sound numbers, a table and a plot that can be read.
#include <isocast/apps/bench/frames.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "well_formed.h"

using namespace isocast::bench;

TEST_CASE("frames: every volume, type and camera, with times and counts") {
  const std::vector<FrameTimes> frames = run_frames({{16, 24}, 64, 1});
  REQUIRE(frames.size() == 5 * 2 * 2 * 3);
  std::set<std::string> names;
  for (const FrameTimes& frame : frames) {
    INFO(frame.volume << ' ' << frame.samples << ' ' << frame.type << ' ' << frame.camera);
    names.insert(frame.volume);
    CHECK(frame.rays == 64 * 64);
    CHECK(frame.hit_rays > 0);
    CHECK(frame.solved > 0);
    for (const double seconds :
         {frame.frame, frame.moving, frame.streams, frame.walk, frame.shadows, frame.binning, frame.solves})
      CHECK((seconds > 0 && seconds < 10));
  }
  CHECK(names.size() == 5);
  CHECK(std::ranges::any_of(frames, &FrameTimes::in_object_order));
  CHECK(rows_of(frames).size() == 5 * frames.size());
  const std::string csv = frames_csv(frames);
  CHECK(std::ranges::count(csv, '\n') == 61);
  CHECK(isocast::test::is_well_formed(frames_plot(frames)));
  CHECK(frames_plot(frames).find("marschner_lobb") != std::string::npos);
  Markup html;
  add_frames(html.open("div"), frames);
  const std::string section = html.finish();
  CHECK(isocast::test::is_well_formed(section));
  CHECK(section.find("noise 24 u8, inside") != std::string::npos);
}
