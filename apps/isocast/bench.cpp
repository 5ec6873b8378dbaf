// isocast bench: error against run time, written as tables.
#include <fmt/format.h>
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/evaluate.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/base/error.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace isocast::verbs {
namespace {

struct BenchOptions {
  std::string suite, folder, isa;
  bool quick = false;
};

void run_bench(const BenchOptions& options) {
  if (options.suite != "cells" && options.suite != "evaluate")
    throw InputError(fmt::format("suite '{}' is unknown; expected cells or evaluate", options.suite));
  const std::vector<Isa> isas =
      options.isa.empty() ? available_isas() : std::vector{isa_from_name(options.isa)};
  bench::prepare_folder(options.folder);
  const bool cells = options.suite == "cells";
  const std::vector<bench::Row> rows =
      cells ? bench::run_cells({options.quick, isas}) : bench::run_evaluate({options.quick, isas});
  bench::write_results(options.folder, rows);
  fmt::print("{}", cells ? bench::cell_summary(rows) : bench::evaluate_summary(rows));
}

}  // namespace

void add_bench(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("bench", "Error against run time, as results.csv and results.json");
  const auto options = std::make_shared<BenchOptions>();
  verb->add_option(
          "suite", options->suite,
          "cells: every cell intersector on every family of cells; evaluate: tapes against compiled formulas")
      ->required();
  verb->add_option("-o,--output", options->folder, "Folder of the result files, made if missing")->required();
  verb->add_flag("--quick", options->quick,
                 "cells: six named cases with fewer rays; evaluate: fewer repetitions");
  verb->add_option(
      "--isa", options->isa,
      "Time one instruction set: auto, scalar, sse4, avx2 or avx512 (default: all that run here)");
  verb->callback([options] { run_bench(*options); });
}

}  // namespace isocast::verbs
