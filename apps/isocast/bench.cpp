// isocast bench: error against run time, as tables and as a report.
#include <fmt/format.h>
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/evaluate.h>
#include <isocast/apps/bench/findings.h>
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
#include <memory>

namespace isocast::verbs {
namespace {

using namespace bench;

void write(const BenchWords& words, const std::vector<Row>& rows, Report report) {
  report.title =
      fmt::format("isocast bench {}", words.scene.input.empty() ? "surfaces, volumes" : words.scene.input);
  report.provenance = provenance();
  write_results(words.folder, rows, report.provenance);
  if (!report.cases.empty()) write_report(words.folder, report);
}

void bench_pictures(const BenchWords& words) {
  const PictureOptions options = picture_options(words);
  const std::vector<PictureCase> cases = picture_cases(words);
  std::vector<Row> rows;
  std::vector<CaseRows> found;
  Report report;
  double harness = 0;
  Progress progress("bench", std::ssize(cases));
  for (const PictureCase& picture : cases) {
    const PictureResult result = run_picture(picture, options);
    rows.insert(rows.end(), result.rows.begin(), result.rows.end());
    report.cases.push_back(report_of(result));
    found.push_back(report.cases.back().rows);
    const double fastest = std::ranges::min(result.rows, {}, &Row::seconds).seconds;
    harness = std::max(harness, result.harness_seconds / fastest);
    progress.add();
  }
  report.notes.push_back(fmt::format(
      "Times are of first_hit over all primary rays, which is what render spends on finding hits. The bench "
      "itself takes at most {:.3f} % of any row's time: as much as a surface takes that answers nothing.",
      100 * harness));
  write(words, rows, std::move(report));
  for (const std::string& sentence : findings(found)) fmt::print("{}\n", sentence);
}

void bench_cells(const BenchWords& words) {
  const std::vector<Row> rows = run_cells({words.quick, isas_of(words)});
  Report report;
  report.cases = cases_of(rows, "voxels");
  write(words, rows, std::move(report));
  fmt::print("{}", cell_summary(rows));
}

void bench_evaluate(const BenchWords& words) {
  const std::vector<Row> rows = run_evaluate({words.quick, isas_of(words)});
  write(words, rows, Report());
  fmt::print("{}", evaluate_summary(rows));
}

// Ends with code 1 where something is not as expected, when all is written.
void bench_stability(const BenchWords& words) {
  StressOptions options;
  options.isa = isas_of(words).back();
  options.cache = picture_options(words).cache;
  if (words.quick) options.size = 10, options.cells = 512;
  const std::vector<StressResult> results = run_stability(options, words.folder);
  const Provenance from = provenance();
  write_results(words.folder, rows_of(results), from);
  write_text_file(std::filesystem::path(words.folder) / "report.html", stability_html(results, from));
  fmt::print("{}", stability_summary(results));
  if (!std::ranges::all_of(results, &StressResult::as_expected)) throw CLI::RuntimeError(1);
}

void run(const BenchWords& words) {
  check(words);
  prepare_folder(words.folder);
  if (words.scene.input == "cells") bench_cells(words);
  else if (words.scene.input == "evaluate") bench_evaluate(words);
  else if (words.scene.input == "stability") bench_stability(words);
  else bench_pictures(words);
}

std::string input_help() {
  std::string help =
      "A suite, or an INPUT of render (a formula, @id, a volume file); without one, all suites of pictures."
      "\ncells: every cell intersector on every family of cells"
      "\nstability: what can break ray tracing, with what is expected of every method"
      "\nevaluate: tapes against compiled formulas, without a report";
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
