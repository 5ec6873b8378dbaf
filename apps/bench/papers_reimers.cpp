// Reimers and Seland: Ray casting algebraic surfaces using the frustum form, 2008: tables 1 to 3.
#include <fmt/format.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_reimers_run.h>

namespace isocast::bench {
namespace {

constexpr double kNotPrinted = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> line_of(std::string_view name, std::initializer_list<double> numbers) {
  std::vector<std::string> line = {std::string(name)};
  for (const double x : numbers) line.push_back(table_number(x));
  return line;
}

PaperTable error_table(const ReimersRun& run) {
  PaperTable table{"T-REI-1",
                   "|f| at the roots that LR finds, over the largest coefficient of the frustum form",
                   {"surface", "paper: mean", "max", "here: mean", "max"},
                   {}};
  for (const SurfaceOfReimers& s : kReimersSurfaces)
    if (const FinderResult* const found = run.result(s.id, finder("frustum-lr")))
      table.rows.push_back(
          line_of(s.name, {s.error_mean, s.error_max, found->search.value_mean, found->search.value_max}));
  return table;
}

PaperTable finder_table(const ReimersRun& run) {
  PaperTable table{"T-REI-2",
                   "Root finders at eps 5e-4: errors in depth, knots inserted a ray, times",
                   {"surface", "finder", "paper: mean", "max", "knots", "time over LR's", "here: mean", "max",
                    "knots", "time over LR's", "rays that fail"},
                   {}};
  for (const SurfaceOfReimers& s : kReimersSurfaces) {
    if (!run.shading(s.id)) continue;
    constexpr FinderOfReimers kNone = {kNotPrinted, kNotPrinted, kNotPrinted, kNotPrinted};
    const FinderOfReimers printed[] = {s.lr, s.lr_mult, s.mr, s.mr_mult, kNone, kNone};
    for (std::size_t f = 0; f < std::size(kFinders); ++f) {
      const MethodSetting setting = finder(kFinders[f]);
      const FinderResult& found = *run.result(s.id, setting);
      std::vector<std::string> line =
          line_of(s.name, {printed[f].mean, printed[f].max, printed[f].its, printed[f].ms / s.lr.ms,
                           found.search.depth_mean, found.search.depth_max, run.knots(s, setting),
                           run.time_ratio(s, setting, finder("frustum-lr"))});
      line.insert(line.begin() + 1, kFinders[f]);
      line.push_back(grouped(found.row.failures()));
      table.rows.push_back(line);
    }
  }
  return table;
}

PaperTable share_table(const ReimersRun& run) {
  PaperTable table{"T-REI-3",
                   "Frames of 512 × 512 a second by LR with shading, and shares of their time, per cent",
                   {"surface", "degree", "paper: frames", "CPU", "rays' coefficients", "roots", "shading",
                    "here: frames", "forms and coefficients", "roots", "shading"},
                   {}};
  for (const SurfaceOfReimers& s : kReimersSurfaces) {
    const ShadingNumbers* const shading = run.shading(s.id);
    if (!shading) continue;
    const double pass = run.result(s.id, finder("frustum-lr"))->row.seconds, roots = run.root_seconds(s),
                 frame = shading->frame, pixels = double(run.size()) * run.size();
    table.rows.push_back(
        line_of(s.name, {double(s.degree), s.fps, double(s.shares[0]), double(s.shares[1]),
                         double(s.shares[2]), double(s.shares[3]), pixels / (512 * 512) / frame,
                         100 * (pass - roots) / frame, 100 * roots / frame, 100 * (frame - pass) / frame}));
  }
  return table;
}

PaperTable normals_table(const ReimersRun& run) {
  PaperTable table{
      "Normals",
      "By kind: nanoseconds a hit on one thread, and degrees from those of the formula's gradient, "
      "median away from edges (no table of the paper)",
      {"surface", "degree", "gradients: ns", "form: ns", "degrees", "neighbours: ns", "degrees",
       "neighbours over gradients"},
      {}};
  for (const SurfaceOfReimers& s : kReimersSurfaces) {
    const ShadingNumbers* const shading = run.shading(s.id);
    if (!shading) continue;
    const double per_hit = 1e9 / double(shading->hits);
    table.rows.push_back(line_of(
        s.name, {double(s.degree), per_hit * shading->gradients, per_hit * shading->form, shading->form_angle,
                 per_hit * shading->neighbours, shading->angle, shading->neighbours / shading->gradients}));
  }
  return table;
}

}  // namespace

Paper reimers_paper(const PaperWishes& wishes) {
  const ReimersRun run(wishes);
  return {kReimersSource,
          {std::begin(kReimersNotes), std::end(kReimersNotes)},
          {error_table(run), finder_table(run), share_table(run), normals_table(run)},
          reimers_claims(run),
          run.rows()};
}

}  // namespace isocast::bench
