#include <fmt/format.h>
#include <isocast/apps/bench/frames.h>
#include <isocast/apps/bench/plot.h>
#include <isocast/apps/bench/report_table.h>
#include <isocast/isa/cpu.h>

#include <algorithm>

namespace isocast::bench {
namespace {

constexpr double kWidth = 490, kHeight = 360, kLeft = 62, kRight = 340, kTop = 16, kBottom = 310;

bool is_plotted(const FrameTimes& frame) { return frame.camera == "outside" && frame.type == "u8"; }
double per_ray(const FrameTimes& frame) { return frame.frame / static_cast<double>(frame.rays); }

// What finding the cells takes, beside solving them.
double cells_of(const FrameTimes& f) {
  return std::max((f.in_object_order ? f.hits : f.streams) - f.solves, 0.0);
}

Row row_of(const FrameTimes& frame, const char* way, double seconds) {
  Row row;
  row.suite = "frames";
  row.case_name = fmt::format("{}_{}_{}", frame.volume, frame.samples, frame.type);
  row.method = way;
  row.isa = name_of(widest_isa());
  row.precision = "float";
  row.setting = frame.camera;
  row.proves = "nothing";
  row.rays = frame.rays;
  row.seconds = seconds;
  row.mrays_per_s = 1e-6 * static_cast<double>(frame.rays) / seconds;
  return row;
}

}  // namespace

std::vector<Row> rows_of(const std::vector<FrameTimes>& frames) {
  std::vector<Row> rows;
  for (const FrameTimes& frame : frames) {
    rows.push_back(row_of(frame, frame.in_object_order ? "object order" : "streams, chosen", frame.frame));
    rows.push_back(row_of(frame, "new iso-value", frame.moving));
    rows.push_back(row_of(frame, "streams", frame.streams));
    rows.push_back(row_of(frame, "walk", frame.walk));
    rows.push_back(row_of(frame, "with shadows", frame.shadows));
  }
  return rows;
}

std::string frames_csv(const std::vector<FrameTimes>& frames) {
  std::string text =
      "volume,samples,type,camera,object_order,rays,hits,cells,solves,ms_frame,ms_new_iso,ms_streams,ms_walk,"
      "ms_shadows,ms_masks,"
      "ms_binning,ms_cells,ms_solves,mrays_per_s,walk_over_frame,new_iso_over_frame,frame_over_solves,shadow_"
      "rays\n";
  for (const FrameTimes& f : frames) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.2f},{:."
        "2f},{:.2f},{:.2f},{}\n",
        f.volume, f.samples, f.type, f.camera, int(f.in_object_order), f.rays, f.hit_rays, f.cells, f.solved,
        1e3 * f.frame, 1e3 * f.moving, 1e3 * f.streams, 1e3 * f.walk, 1e3 * f.shadows, 1e3 * f.masks(),
        1e3 * f.binning, 1e3 * cells_of(f), 1e3 * f.solves, 1e-6 * double(f.rays) / f.frame, f.walk / f.frame,
        f.moving / f.frame, f.frame / f.solves, f.shadow_rays);
  }
  return text;
}

std::string frames_summary(const std::vector<FrameTimes>& frames) {
  std::string text =
      fmt::format("{:<24} {:<9} {:>9} {:>10} {:>13} {:>9} {:>13} {:>13}\n", "volume", "camera", "Mrays/s",
                  "walk/frame", "streams/frame", "new iso", "shadow rays", "frame/solves");
  for (const FrameTimes& f : frames)
    text += fmt::format("{:<24} {:<9} {:>9.2f} {:>9.2f}x {:>12.2f}x {:>8.2f}x {:>12.2f}x {:>12.1f}x{}\n",
                        fmt::format("{} {} {}", f.volume, f.samples, f.type), f.camera,
                        1e-6 * double(f.rays) / f.frame, f.walk / f.frame, f.streams / f.frame,
                        f.moving / f.frame, (f.shadows - f.frame) / f.frame, f.frame / f.solves,
                        f.in_object_order ? "" : "  (streams chosen)");
  return text;
}

std::string frames_plot(const std::vector<FrameTimes>& frames) {
  std::vector<double> times, sizes;
  std::vector<std::string> volumes;
  for (const FrameTimes& frame : frames) {
    if (!is_plotted(frame)) continue;
    times.push_back(per_ray(frame));
    sizes.push_back(frame.samples);
    if (std::ranges::find(volumes, frame.volume) == volumes.end()) volumes.push_back(frame.volume);
  }
  Plot plot("growth", kWidth, kHeight);
  const LogAxis up = log_axis(times, kBottom, kTop), across = log_axis(sizes, kLeft, kRight);
  plot.error_ticks(up, kLeft, kRight);
  plot.upright(14, 0.5 * (kTop + kBottom), "seconds per ray");
  std::ranges::sort(sizes);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  for (const double size : sizes) {
    plot.line("grid", across.place(size), kTop, across.place(size), kBottom);
    plot.text(across.place(size), kBottom + 16, "tick middle", fmt::format("{}", size));
  }
  plot.text(0.5 * (kLeft + kRight), kBottom + 36, "name middle", "samples along an edge");
  for (std::size_t v = 0; v < volumes.size(); ++v) {
    std::vector<std::array<double, 2>> line;
    for (const FrameTimes& frame : frames)
      if (is_plotted(frame) && frame.volume == volumes[v]) {
        line.push_back({across.place(frame.samples), up.place(per_ray(frame))});
        plot.mark({v % 4, false, line.back()[0], line.back()[1], 4, method_color(v)},
                  fmt::format("{} {}: {}", frame.volume, frame.samples, short_time(per_ray(frame))));
      }
    plot.join(line, "sweep", method_color(v));
    plot.mark({v % 4, false, kRight + 16, kTop + 10 + 18 * double(v), 4, method_color(v)});
    plot.text(kRight + 26, kTop + 14 + 18 * double(v), "key", volumes[v]);
  }
  return plot.finish();
}

void add_frames(Markup& html, const std::vector<FrameTimes>& frames) {
  html.element("h2", {{"id", "frames"}}, "frames of growing volumes");
  html.element("p", {{"class", "soft"}},
               "Whole pictures with shading on one thread. Stages in milliseconds: making the masks of an "
               "iso-value, binning bricks, finding cells, and what their solves alone would take; then how "
               "many times as long as the frame other ways take.");
  html.open("div", {{"class", "card"}}).open("div", {{"class", "plots"}});
  html.open("div").append(frames_plot(frames)).close().close().close();
  const auto times = [](double ratio) { return fmt::format("{:.2f}x", ratio); };
  const auto ms = [](double seconds) { return fmt::format("{:.2f}", 1e3 * seconds); };
  std::vector<std::vector<std::string>> rows;
  for (const FrameTimes& f : frames)
    rows.push_back({fmt::format("{} {} {}, {}{}", f.volume, f.samples, f.type, f.camera,
                                f.in_object_order ? "" : " (by streams)"),
                    fmt::format("{:.1f}", 1e-6 * double(f.rays) / f.frame), ms(f.masks()), ms(f.binning),
                    ms(cells_of(f)), ms(f.solves), times(f.frame / f.solves), times(f.moving / f.frame),
                    times(f.streams / f.frame), times(f.walk / f.frame), times(f.shadows / f.frame)});
  add_text_table(html,
                 {"frame", "Mrays/s", "masks", "binning", "cells", "solves", "frame over solves",
                  "new iso-value", "by streams", "by the walk", "with shadows"},
                 rows);
}

}  // namespace isocast::bench
