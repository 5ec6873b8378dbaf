#include <fmt/format.h>
#include <isocast/apps/bench/cell_case.h>
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/cells.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/base/progress.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::string_view kQuickFamilies[] = {"random",      "smooth", "double-root",
                                               "close-roots", "thin",   "mc-2-face"};

std::vector<CellSetting> settings() {
  std::vector<CellSetting> all = {cell_setting("midpoint"), cell_setting("linear"),
                                  cell_setting("schwarze", {{"stable", "1"}}),
                                  cell_setting("marmitt", {{"adaptive", "1"}}), cell_setting("certified")};
  for (const char* method : {"neubauer", "marmitt"})
    for (const char* iterations : {"1", "2", "3", "5", "10"})
      all.push_back(cell_setting(method, {{"iterations", iterations}}));
  return all;
}

CellCase make_case(const CellFamily& family, bool quick) {
  const std::uint64_t rays = quick ? 8'192 : family.name.starts_with("mc-") ? kPictureRays : 16'384;
  CellCase result{
      "cells", std::string(family.name), make_cells(family, kSeed, 0, rays, Rounding::to_float), {}};
  result.truth = reference::solve(result.chords);
  return result;
}

}  // namespace

std::vector<Row> run_cells(const CellSuiteOptions& options) {
  std::vector<CellFamily> families(cell_families().begin(), cell_families().end());
  if (options.quick) {
    families.clear();
    for (const std::string_view name : kQuickFamilies) families.push_back(cell_family(name));
  }
  const std::vector<CellSetting> all = settings();
  std::vector<Row> rows;
  Progress progress("bench cells", static_cast<std::int64_t>(families.size()));
  for (const CellFamily& family : families) {
    const CellCaseOptions how{.isas = options.isas, .repetitions = options.quick ? 9 : 7};
    const std::vector<Row> found = run_cell_case(make_case(family, options.quick), all, how);
    rows.insert(rows.end(), found.begin(), found.end());
    progress.add();
  }
  mark_pareto(rows);
  return rows;
}

std::string cell_summary(const std::vector<Row>& rows) {
  // seconds of a row, or nothing where it was not run
  const auto seconds = [&](std::string_view family, std::string_view precision, std::string_view method,
                           std::string_view setting, Isa isa) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      return row.case_name == family && row.precision == precision && row.method == method &&
             row.setting == setting && row.isa == name_of(isa);
    });
    return found == rows.end() ? std::nan("") : found->seconds;
  };
  const Isa narrow = isa_from_name(rows.front().isa), wide = isa_from_name(rows.back().isa);
  struct Speed {
    std::string_view method, setting;
  };
  constexpr Speed kAdaptive{"marmitt", "adaptive=1"}, kThree{"marmitt", "iterations=3"},
      kNeubauer{"neubauer", "iterations=3"}, kSchwarze{"schwarze", "stable=1"};

  std::string text = fmt::format(
      "Times ({} to {}, marmitt by its default adaptive=1 | with iterations=3, neubauer with iterations=3)\n",
      name_of(narrow), name_of(wide));
  for (const char* family : {"random", "smooth"})
    for (const char* precision : {"float", "double"}) {
      const auto time = [&](const Speed& speed, Isa isa) {
        return seconds(family, precision, speed.method, speed.setting, isa);
      };
      const auto gain = [&](const Speed& speed) { return time(speed, narrow) / time(speed, wide); };
      text += fmt::format(
          "{:7} {:7} schwarze/marmitt, {}: {:.2f} | {:.2f}   marmitt/neubauer, {}: {:.2f} | {:.2f}\n", family,
          precision, name_of(narrow), time(kSchwarze, narrow) / time(kAdaptive, narrow),
          time(kSchwarze, narrow) / time(kThree, narrow), name_of(narrow),
          time(kAdaptive, narrow) / time(kNeubauer, narrow), time(kThree, narrow) / time(kNeubauer, narrow));
      text += fmt::format(
          "{:15} gain of {} over {}: marmitt {:.2f} | {:.2f}, neubauer {:.2f}, schwarze {:.2f}\n", "",
          name_of(wide), name_of(narrow), gain(kAdaptive), gain(kThree), gain(kNeubauer), gain(kSchwarze));
    }
  return text;
}

}  // namespace isocast::bench
