// isocast info: what a volume file or a formula holds, as a table or as JSON.
#include <fmt/format.h>
#include <isocast/apps/isocast/formula_info.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/isocast/volume_options.h>
#include <isocast/base/mapped_file.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/statistics.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

namespace isocast::verbs {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string file;
  ReadOptions read;
  bool json = false;
  std::vector<std::string> params;
  std::string time = "0";
};

// The grid in the world: origin, and direction and spacing of each axis.
struct Placement {
  Double3 origin, spacing;
  std::array<Double3, 3> axes;
};

// The origin is the first sample's place; of a sparse grid, the corner of the box of its active ones. A
// negative zero would only puzzle: adding 0 makes it 0.
Placement placement_of(const Volume& volume) {
  Placement placement;
  Double3 first = {0, 0, 0};
  if (volume.tree && volume.tree->active_count() > 0)
    std::ranges::copy(volume.tree->first_active(), first.begin());
  const Double3 origin = volume.world_from_grid.point(first);
  for (int a = 0; a < 3; ++a) {
    Double3 step;
    for (int r = 0; r < 3; ++r) step[r] = volume.world_from_grid.m[r][a] + 0.0;
    placement.origin[a] = origin[a] + 0.0;
    placement.spacing[a] = length(step);
    placement.axes[a] = normalized(step);
  }
  return placement;
}

double megabytes(const Volume& volume) { return static_cast<double>(volume.bytes()) / 1e6; }

// What only sparse grids have.
Json tree_json(const Volume& volume) {
  const SparseTree& tree = *volume.tree;
  return {{"name", volume.grid_name},           {"class", volume.grid_class},
          {"other_grids", volume.other_grids},  {"index_first", tree.first_active()},
          {"index_last", tree.last_active()},   {"active_samples", tree.active_count()},
          {"leaves", tree.leaves().size()},     {"active_tiles", tree.active_tiles().size()},
          {"half_on_disk", volume.half_on_disk}};
}

void print_json(const Volume& volume, const VolumeStatistics& statistics) {
  const Placement placement = placement_of(volume);
  Json percentiles = Json::object();
  for (const Percentile& p : statistics.percentiles) percentiles[fmt::format("{}", p.percent)] = p.value;
  const Histogram& histogram = statistics.histogram;
  Json info = {{"format", volume.format},
               {"dims", volume.dims},
               {"type", volume.type_name()},
               {"spacing", placement.spacing},
               {"origin", placement.origin},
               {"axes", placement.axes},
               {"slope", volume.slope},
               {"intercept", volume.intercept},
               {"range", {statistics.min, statistics.max}},
               {"nan_count", statistics.nan_count},
               {"infinite_count", statistics.infinite_count},
               {"histogram", {{"lo", histogram.lo}, {"hi", histogram.hi}, {"counts", histogram.counts}}},
               {"percentiles", percentiles},
               {"suggested_iso", statistics.suggested_iso},
               {"memory_mb", megabytes(volume)},
               {"mapped", volume.mapped}};
  if (volume.tree) info["grid"] = tree_json(volume);
  fmt::print("{}\n", info.dump(2));
}

// The histogram in few rows, bars by the square root of the counts: a volume is mostly empty space.
void print_histogram(const Histogram& histogram) {
  constexpr int kRows = 16, kBinsPerRow = Histogram::kBins / kRows, kWidth = 48;
  std::array<std::int64_t, kRows> counts;
  for (int r = 0; r < kRows; ++r) {
    const auto first = histogram.counts.begin() + r * kBinsPerRow;
    counts[r] = std::accumulate(first, first + kBinsPerRow, std::int64_t(0));
  }
  const double most =
      std::sqrt(static_cast<double>(std::max<std::int64_t>(1, *std::ranges::max_element(counts))));
  fmt::print("histogram  (bars: square root of the number of samples)\n");
  for (int r = 0; r < kRows; ++r) {
    const double position = static_cast<double>(r) / kRows;
    const int bar = static_cast<int>(std::ceil(kWidth * std::sqrt(static_cast<double>(counts[r])) / most));
    fmt::print("  {:>10.5g}  {:{}}  {}\n", (1 - position) * histogram.lo + position * histogram.hi,
               std::string(bar, '#'), kWidth, counts[r]);
  }
}

void print_table(const std::string& file, const Volume& volume, const VolumeStatistics& statistics) {
  const Placement placement = placement_of(volume);
  const auto row = [](std::string_view name, const std::string& value) {
    fmt::print("{:<10} {}\n", name, value);
  };
  const auto numbers = [](const auto& values) { return fmt::format("{:.6g}", fmt::join(values, " ")); };
  row("file", file);
  row("format", volume.format);
  row("dims", fmt::format("{} x {} x {}", volume.dims[0], volume.dims[1], volume.dims[2]));
  row("type",
      fmt::format("{}{}", volume.type_name(), volume.half_on_disk ? ", saved as half precision" : ""));
  if (volume.tree) {
    const SparseTree& tree = *volume.tree;
    row("grid",
        fmt::format("'{}'{}{}", volume.grid_name, volume.grid_class.empty() ? "" : ", ", volume.grid_class));
    if (!volume.other_grids.empty()) row("others", fmt::format("'{}'", fmt::join(volume.other_grids, "' '")));
    row("active",
        fmt::format("{:.0f} samples from ({}) to ({}), in {} leaves and {} tiles", tree.active_count(),
                    fmt::join(tree.first_active(), " "), fmt::join(tree.last_active(), " "),
                    tree.leaves().size(), tree.active_tiles().size()));
  }
  row("memory", fmt::format("{:.4g} MB{}", megabytes(volume), volume.mapped ? ", mapped from the file" : ""));
  row("spacing", numbers(placement.spacing));
  row("origin", numbers(placement.origin));
  row("axes", fmt::format("({})  ({})  ({})", numbers(placement.axes[0]), numbers(placement.axes[1]),
                          numbers(placement.axes[2])));
  if (volume.slope != 1 || volume.intercept != 0)
    row("values", fmt::format("{:.6g} * stored + {:.6g}", volume.slope, volume.intercept));
  row("range", fmt::format("{:.6g} to {:.6g}", statistics.min, statistics.max));
  if (statistics.nan_count + statistics.infinite_count > 0)
    row("left out", fmt::format("{} NaN, {} infinite", statistics.nan_count, statistics.infinite_count));
  row("iso-values", numbers(statistics.suggested_iso));
  std::string percentiles;
  for (const Percentile& p : statistics.percentiles)
    percentiles += fmt::format("{}%: {:.5g}  ", p.percent, p.value);
  row("percentile", percentiles.substr(0, percentiles.size() - 2));
  if (statistics.finite_count > 0) print_histogram(statistics.histogram);
}

void run(const InfoOptions& options) {
  const Parameters parameters = parse_parameters(options.params, "--param");
  if (!is_volume_file(typed_formula(options.file), parameters) && !std::filesystem::exists(options.file)) {
    print_formula_info(read_formula({typed_formula(options.file), parameters, {}}),
                       parse_number(options.time, "--time"), options.json);
    return;
  }
  const Volume volume = read_volume(options.file, options.read);
  const VolumeStatistics statistics = statistics_of(volume);
  check_mapped_files();
  if (options.json) print_json(volume, statistics);
  else print_table(options.file, volume, statistics);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "info",
      "What a volume file holds: dimensions, type, range, histogram, iso-values; or a formula: "
      "whether it is a polynomial, and its terms");
  const auto options = std::make_shared<InfoOptions>();
  verb->add_option("FILE", options->file,
                   "A volume: .raw .nrrd .nhdr .mhd .mha .nii .nii.gz .vti .vdb .nvdb; a formula, or @id")
      ->required();
  verb->add_option("--param", options->params, "NAME=VALUE: a parameter of the formula")
      ->allow_extra_args(false);
  verb->add_option("--time", options->time, "Time, the variable w of the formula (default 0)");
  verb->add_flag("--json", options->json, "One object on stdout");
  add_read_options(*verb, options->read);
  verb->callback([options] { run(*options); });
}

}  // namespace isocast::verbs
