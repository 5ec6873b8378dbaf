// Marmitt, Kleer, Wald, Friedrich, Slusallek: Fast and accurate ray-voxel intersection techniques for
// iso-surface ray tracing, VMV 2004: tables 1 to 4, Figure 1, and the claims.
#include <fmt/format.h>
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/papers_marmitt_run.h>
#include <isocast/data_gen/write.h>
#include <isocast/implicit/expression/parse.h>

#include <algorithm>
#include <numeric>

namespace isocast::bench {
namespace {

using enum Tried;

std::vector<double> speeds(const MarmittRun& run, const std::vector<std::string>& names, Tried tried,
                           Isa isa) {
  std::vector<double> all;
  for (const std::string& name : names) all.push_back(run.row(name, tried, isa).mrays_per_s);
  return all;
}

PaperTable synthetic_table(const MarmittRun& run, Isa isa) {
  const bool simd = isa != Isa::scalar;
  PaperTable table{
      simd ? "T-MAR-2" : "T-MAR-1",
      fmt::format("Synthetic cells, {}, million intersections per second: least, largest and mean of "
                  "seven configurations",
                  name_of(isa)),
      {"intersector", "correct", "paper: min", "max", "avg", "here: min", "max", "avg"},
      {}};
  for (std::size_t m = 0; m < std::size(kSpeeds); ++m) {
    const SpeedsOfPaper& theirs = kSpeeds[m];
    const std::vector<double> ours = speeds(run, run.synthetic(), Tried(m), isa);
    const double mean = std::accumulate(ours.begin(), ours.end(), 0.0) / static_cast<double>(ours.size());
    std::vector<std::string> line = {std::string(theirs.name), theirs.correct ? "yes" : "no"};
    for (const double x : simd ? theirs.synthetic_simd : theirs.synthetic) line.push_back(table_number(x));
    for (const double x : {std::ranges::min(ours), std::ranges::max(ours), mean})
      line.push_back(table_number(x));
    table.rows.push_back(line);
  }
  return table;
}

PaperTable scan_table(const MarmittRun& run, Isa isa) {
  const bool simd = isa != Isa::scalar;
  PaperTable table{simd ? "T-MAR-4" : "T-MAR-3",
                   fmt::format("Scans, {}, million intersections per second", name_of(isa)),
                   {"intersector", "correct", "paper: bonsai", "aneurism", "engine"},
                   {}};
  for (const std::string& name : run.scans()) table.columns.push_back("here: " + name);
  for (std::size_t m = 0; m < std::size(kSpeeds); ++m) {
    const SpeedsOfPaper& theirs = kSpeeds[m];
    std::vector<std::string> line = {std::string(theirs.name), theirs.correct ? "yes" : "no"};
    for (const double x : simd ? theirs.scans_simd : theirs.scans) line.push_back(table_number(x));
    for (const double x : speeds(run, run.scans(), Tried(m), isa)) line.push_back(table_number(x));
    table.rows.push_back(line);
  }
  return table;
}

// A volume of one cell with two sheets, one behind the other on many rays.
PictureResult two_sheets(const PaperWishes& wishes) {
  const std::filesystem::path file = wishes.folder / "volumes" / "two_roots.nrrd";
  prepare_folder(file.parent_path());
  write_field(formula_field(parse_expression("(1-y)*(1-z) + y*z")), {{2, 2, 2}, {{0, 0, 0}, {1, 1, 1}}}, file,
              {});
  const int size = wishes.quick ? 48 : 128;
  PictureCase picture{"papers", "two_roots", {}, size, size};
  picture.scene.objects.front().source = VolumeSource{file, {}};
  picture.scene.objects.front().iso = {0.6};
  picture.scene.camera.position = {0.5, -1.6, -1.4};
  picture.scene.camera.up = {1, 0, 0};
  PictureOptions options;
  for (const CellSetting& setting : settings_of_marmitt())
    options.chosen.push_back({setting.method, setting.text, "nothing", setting.set});
  options.isas = {four_lanes()};
  options.precisions = {"float"};
  options.repetitions = 3;
  options.cache = wishes.cache;
  return run_picture(picture, options);
}

PaperTable figure(const PictureResult& result) {
  const auto two = std::ranges::count_if(result.truth.rays, [](const auto& ray) {
    return std::ranges::count(ray.roots, true, &reference::RayRoot::crossing) == 2;
  });
  PaperTable table{"Figure 1",
                   fmt::format("One cell with two sheets, {} rays, of which {} cross both",
                               grouped(result.picture.rays()), grouped(two)),
                   {"intersector", "false misses", "false hits", "other root", "error p50, voxels", "max"},
                   {}};
  for (const Row& row : result.rows)
    table.rows.push_back({row.method + " " + row.setting, grouped(row.false_misses), grouped(row.false_hits),
                          grouped(row.wrong_root), table_number(row.t_error_p50),
                          table_number(row.t_error_max)});
  return table;
}

std::vector<Claim> claims(const MarmittRun& run) {
  std::vector<Claim> all;
  const auto add = [&all](Claim claim) { all.push_back(std::move(claim)); };
  const std::vector<std::string>&scans = run.scans(), &synthetic = run.synthetic();
  const Isa simd = run.simd();
  double depth = 0;
  for (const std::string& name : synthetic)
    depth = std::max(depth, run.row(name, midpoint, Isa::scalar).t_error_max);
  add(measured("R-MAR-1", "Midpoint errs by up to a voxel: blocks", "largest error in voxels", {0.5, 1.74},
               {depth}));
  const double by_linear = run.sum(&Row::false_misses, linear);
  add(measured("R-MAR-2", "Linear misses rays with two roots in a cell",
               "its false misses over chords with two roots", {0.99, 1.01}, {by_linear / run.two_roots()}));
  add(measured("R-MAR-3", "Neubauer misses the same rays", "its false misses over those of linear",
               {0.99, 1.01}, {run.sum(&Row::false_misses, neubauer) / by_linear}));
  add(measured("R-MAR-3", "Neubauer can return the last of three roots", "other roots", {1},
               {run.sum(&Row::wrong_root, neubauer)}));
  add(measured("R-MAR-4", "Ten iterations of Neubauer do not repair it",
               "false misses with ten over with three", {0.99, 1.01},
               {run.sum(&Row::false_misses, ten) / run.sum(&Row::false_misses, neubauer)}));
  const double cells = run.sum(&Row::rays, marmitt);
  add(measured("R-MAR-5", "Schwarze and the new method give the same, correct hits",
               "share of chords that fail in double, Schwarze and new", {0, 1e-3},
               {run.failures(schwarze, "double") / cells, run.failures(marmitt, "double") / cells}));
  add(measured("R-MAR-6", "After isolation the bracket holds the first root", "other roots in double", {0, 0},
               {run.sum(&Row::wrong_root, marmitt, "double")}));
  add(measured("R-MAR-7", "The new method is more stable than Schwarze in single precision",
               "failures of Schwarze over those of new, float", {1.5},
               {run.failures(schwarze, "float") / run.failures(marmitt, "float")}));
  add(measured("R-MAR-8", "New is 1.7 to 1.9 times faster than Schwarze on scans, scalar",
               "Schwarze's time over new's", {1.7},
               run.ratios(scans, marmitt, Isa::scalar, schwarze, Isa::scalar)));
  add(measured("R-MAR-9", "New is about as fast as Neubauer, scalar (0.94)",
               "speed of new over Neubauer, scans", {0.8, 1.2},
               run.ratios(scans, marmitt, Isa::scalar, neubauer, Isa::scalar)));
  add(measured("R-MAR-9", "With SIMD 60 % of it", "speed of new over Neubauer, scans", {0.45, 0.8},
               run.ratios(scans, marmitt, simd, neubauer, simd)));
  const auto gain = [&](Tried tried) { return run.ratios(scans, tried, simd, tried, Isa::scalar); };
  add(measured("R-MAR-10", "SIMD makes new 50 to 60 % faster", "speed over scalar, scans", {1.5},
               gain(marmitt)));
  add(measured("R-MAR-10", "SIMD makes Neubauer 2.3 to 2.6 times faster", "speed over scalar, scans", {2},
               gain(neubauer)));
  add(measured("R-MAR-10", "SIMD makes linear about twice as fast", "speed over scalar, scans", {1.8},
               gain(linear)));
  add(measured("R-MAR-10", "Schwarze gets slower with SIMD", "speed over scalar, scans", {0, 1},
               gain(schwarze)));
  add(measured("R-MAR-11", "Three fixed iterations are faster than an adaptive stop",
               "time with the stop over time with three, scans", {1.05},
               run.ratios(scans, marmitt, Isa::scalar, adaptive, Isa::scalar)));
  add(untested("R-MAR-12", "f along the ray is a cubic whose coefficients are sums over the corners",
               "an identity, which the unit tests hold against exact arithmetic"));
  add(measured("R-MAR-13", "Trilinear ends are no slower than bilinear on the face",
               "time with face=1 over face=0, Neubauer on scans", {0.95},
               run.ratios(scans, neubauer, Isa::scalar, face, Isa::scalar)));
  add(measured("R-MAR-14",
               "On synthetic cells, scalar, new is no faster than Schwarze (table 1, against the "
               "abstract's factor of three)",
               "Schwarze's time over new's", {0, 1.1},
               run.ratios(synthetic, marmitt, Isa::scalar, schwarze, Isa::scalar)));
  return all;
}

}  // namespace

Paper marmitt_paper(const PaperWishes& wishes) {
  MarmittRun run(wishes);
  const PictureResult sheets = two_sheets(wishes);
  Paper paper{kMarmittSource, {kMarmittNote}, {}, claims(run), {}};
  paper.notes.insert(paper.notes.end(), run.notes().begin(), run.notes().end());
  paper.tables = {synthetic_table(run, Isa::scalar), synthetic_table(run, run.simd()),
                  scan_table(run, Isa::scalar), scan_table(run, run.simd()), figure(sheets)};
  paper.rows = run.take_rows();
  paper.rows.insert(paper.rows.end(), sheets.rows.begin(), sheets.rows.end());
  return paper;
}

}  // namespace isocast::bench
