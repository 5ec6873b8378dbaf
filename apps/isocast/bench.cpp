// isocast bench: error against run time, as tables and as a report.
#include <fmt/format.h>
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/evaluate.h>
#include <isocast/apps/bench/findings.h>
#include <isocast/apps/bench/frames.h>
#include <isocast/apps/bench/papers.h>
#include <isocast/apps/bench/picture_report.h>
#include <isocast/apps/bench/stability_report.h>
#include <isocast/apps/bench/suites.h>
#include <isocast/apps/isocast/bench_words.h>
#include <isocast/apps/isocast/scene_options.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>
#include <isocast/base/progress.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <memory>

namespace isocast::verbs {
namespace {

using namespace bench;

// What suites have found, one after the other.
struct Findings {
  std::vector<Row> rows;
  Report report;
  std::string text;

  void add(const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); }
};

// The tests' switch to full size.
bool nightly() { return std::getenv("ISOCAST_NIGHTLY") != nullptr; }

void bench_pictures(const BenchWords& words, Findings& all) {
  const PictureOptions options = picture_options(words);
  const std::vector<PictureCase> cases = picture_cases(words);
  std::vector<CaseRows> found;
  double harness = 0;
  Progress progress("bench", std::ssize(cases));
  for (const PictureCase& picture : cases) {
    const PictureResult result = run_picture(picture, options);
    all.add(result.rows);
    all.report.cases.push_back(report_of(result));
    found.push_back(all.report.cases.back().rows);
    const double fastest = std::ranges::min(result.rows, {}, &Row::seconds).seconds;
    harness = std::max(harness, result.harness_seconds / fastest);
    progress.add();
  }
  all.report.notes.push_back(fmt::format(
      "Times are of first_hit over all primary rays, which is what render spends on finding hits. The bench "
      "itself takes at most {:.3f} % of any row's time: as much as a surface takes that answers nothing.",
      100 * harness));
  for (const std::string& sentence : findings(found)) all.text += sentence + "\n";
}

void bench_cells(const BenchWords& words, Findings& all) {
  const std::vector<Row> rows = run_cells({words.quick, isas_of(words)});
  all.add(rows);
  for (ReportCase& one : cases_of(rows, "voxels")) all.report.cases.push_back(std::move(one));
  all.text += cell_summary(rows);
}

void bench_evaluate(const BenchWords& words, Findings& all) {
  all.add(run_evaluate({words.quick, isas_of(words)}));
  all.text += evaluate_summary(all.rows);
}

// Frames of volumes: a table of their own beside the rows.
void bench_frames(const BenchWords& words, Findings& all) {
  FrameOptions options;
  if (words.quick) options = {{32, 64}, 256, 2};
  else if (nightly()) options.sizes.push_back(1024);
  const std::vector<FrameTimes>& frames = all.report.frames = run_frames(options);
  all.add(rows_of(frames));
  write_text_file(std::filesystem::path(words.folder) / "frames.csv", frames_csv(frames));
  all.text += frames_summary(frames);
}

// The suite has a report of its own. Whether all is as expected.
bool bench_stability(const BenchWords& words, const std::filesystem::path& folder, Findings& all) {
  StressOptions options;
  options.isa = isas_of(words).back();
  options.cache = cache_of(words);
  if (words.quick) options.size = 10, options.cells = 512;
  prepare_folder(folder);
  const std::vector<StressResult> results = run_stability(options, folder);
  all.add(rows_of(results));
  write_text_file(folder / "report.html", stability_html(results, provenance()));
  all.text += stability_summary(results);
  return std::ranges::all_of(results, &StressResult::as_expected);
}

void bench_papers(const BenchWords& words, Findings& all) {
  all.report.papers = run_papers({words.quick, words.folder, words.data, cache_of(words)});
  for (const Paper& paper : all.report.papers) all.add(paper.rows);
  all.text += papers_summary(all.report.papers);
}

// One suite, the INPUT, or all. Ends with code 1 where stability is not as expected, when all is written.
void run(const BenchWords& words) {
  check(words);
  prepare_folder(words.folder);
  const std::string& input = words.scene.input;
  Findings all;
  if (input == "cells" || input == "all") bench_cells(words, all);
  if (input == "evaluate") bench_evaluate(words, all);
  if (has_pictures(words)) bench_pictures(words, all);
  if (input == "frames" || input == "volumes") bench_frames(words, all);
  bool as_expected = true;
  if (input == "stability") as_expected = bench_stability(words, words.folder, all);
  if (input == "all")
    as_expected = bench_stability(words, std::filesystem::path(words.folder) / "stability", all);
  if (input == "papers" || input == "all") bench_papers(words, all);

  Report& report = all.report;
  report.title = fmt::format("isocast bench {}", input.empty() ? "surfaces, volumes" : input);
  report.provenance = provenance();
  write_results(words.folder, all.rows, report.provenance);
  if (!report.cases.empty() || !report.frames.empty() || !report.papers.empty())
    write_report(words.folder, report);
  fmt::print("{}", all.text);
  if (!as_expected) throw CLI::RuntimeError(1);
}

std::string input_help() {
  std::string help =
      "A suite, or an INPUT of render (a formula, @id, a volume file); without one, all suites of pictures."
      "\ncells: every cell intersector on every family of cells"
      "\nstability: what can break ray tracing, with what is expected of every method"
      "\nframes: test volumes of growing size as whole frames, stage by stage; volumes runs them too"
      "\nevaluate: tapes against compiled formulas, without a report"
      "\npapers: the papers' tables with our figures beside theirs, and their claims"
      "\nall: cells, all suites of pictures and papers in one report, and stability beside it";
  for (const PictureSuite& suite : picture_suites())
    help += fmt::format("\n{}: {}", suite.name, suite.meaning);
  return help;
}

}  // namespace

void add_bench(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "bench", "Error against run time: results.csv, results.json, report.html and its plots as SVG");
  const auto words = std::make_shared<BenchWords>();
  add_scene_options(*verb, words->scene,
                    "NAME[,NAME...] that 'isocast methods' lists (default: all that apply)");
  verb->get_option("INPUT")->required(false)->description(input_help());
  verb->get_option("--size")->description("WIDTHxHEIGHT in pixels of an INPUT (default 128x128)");
  verb->get_option("--set")->description("An option of the methods, KEY=VALUE; then nothing is swept");
  verb->get_option("--isa")->description(
      "Time one instruction set: auto, scalar, sse4, avx2 or avx512 (default: all that run here)");
  verb->add_option("-o,--output", words->folder, "Folder of the result files, made if missing")->required();
  verb->add_option("--data", words->data,
                   "Folder of bonsai.vti, aneurism.vti and engine.vti for papers (default: test volumes)");
  verb->add_flag("--quick", words->quick,
                 "Six named cases, three of a suite of pictures, with fewer rays and settings");
  verb->add_option("--precision", words->precision, "float or double (default: both)")
      ->check(CLI::IsMember({"float", "double"}));
  verb->add_option(
      "--cache", words->cache,
      "Folder in which the reference's answers are kept (default: ~/.cache/isocast/reference), or none");
  verb->callback([words] { run(*words); });
}

}  // namespace isocast::verbs
