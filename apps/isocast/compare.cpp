// isocast compare: hit mask, depth, normal and colour of two pictures with layers.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/compare_images.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

namespace isocast::verbs {
namespace {

using json = nlohmann::ordered_json;

struct CompareWords {
  std::string a, b, output, tolerance = "0";
  bool as_json = false;
};

json json_of(const std::vector<PixelDifference>& pixels) {
  json list = json::array();
  for (const PixelDifference& p : pixels)
    list.push_back({{"pixel", {p.x, p.y}}, {"difference", p.difference}});
  return list;
}

json json_of(const Comparison& c, double tolerance) {
  json result = {{"size", {c.width, c.height}}, {"tolerance", tolerance}, {"within", c.within(tolerance)}};
  if (!c.mask.by.empty()) {
    json pixels = json::array();
    for (const PixelDifference& p : c.mask.first) pixels.push_back({p.x, p.y});
    result["hit_mask"] = {{"by", c.mask.by},         {"both", c.mask.both},       {"only_a", c.mask.only_a},
                          {"only_b", c.mask.only_b}, {"neither", c.mask.neither}, {"pixels", pixels}};
  }
  for (const LayerDifference& layer : c.layers)
    result["layers"][layer.name] = {{"unit", layer.unit},       {"pixels", layer.pixels},
                                    {"p50", layer.p50},         {"p90", layer.p90},
                                    {"p99", layer.p99},         {"max", layer.max},
                                    {"decides", layer.decides}, {"worst", json_of(layer.worst)}};
  result["only_a"] = c.only_a;
  result["only_b"] = c.only_b;
  return result;
}

void print(const Comparison& c, double tolerance) {
  constexpr std::size_t kListed = 3;
  if (!c.mask.by.empty()) {
    fmt::print("hit mask (by {}): {} in both, {} only in A, {} only in B, {} in neither\n", c.mask.by,
               c.mask.both, c.mask.only_a, c.mask.only_b, c.mask.neither);
    for (std::size_t i = 0; i < std::min(kListed, c.mask.first.size()); ++i)
      fmt::print("  differs at {},{}\n", c.mask.first[i].x, c.mask.first[i].y);
  }
  fmt::print("{:<11} {:<12} {:>9} {:>10} {:>10} {:>10} {:>10}  worst pixels\n", "layer", "unit", "pixels",
             "p50", "p90", "p99", "max");
  for (const LayerDifference& layer : c.layers) {
    std::string worst;
    for (std::size_t i = 0; i < std::min(kListed, layer.worst.size()); ++i)
      worst += fmt::format(" {},{}", layer.worst[i].x, layer.worst[i].y);
    fmt::print("{:<11} {:<12} {:>9} {:>10.3g} {:>10.3g} {:>10.3g} {:>10.3g} {}\n", layer.name, layer.unit,
               layer.pixels, layer.p50, layer.p90, layer.p99, layer.max, worst);
  }
  for (const auto& [names, who] : {std::pair{&c.only_a, "A"}, {&c.only_b, "B"}})
    if (!names->empty()) fmt::print("only in {}: {}\n", who, fmt::join(*names, ", "));
  fmt::print("{} the tolerance {}\n", c.within(tolerance) ? "within" : "BEYOND", tolerance);
}

void run(const CompareWords& words) {
  const double tolerance = parse_number(words.tolerance, "--tolerance");
  if (tolerance < 0)
    throw InputError(fmt::format("--tolerance {}: expected a number of at least 0", tolerance));
  if (!words.output.empty()) {
    if (!words.output.ends_with(".png"))
      throw InputError(fmt::format("-o {}: expected a name that ends with .png", words.output));
    const OutputFile writable(words.output);  // a bad name fails before the work
  }
  const Comparison comparison = compare_images(read_exr(words.a), read_exr(words.b));
  if (!words.output.empty())
    write_png(words.output, comparison.width, comparison.height, difference_picture(comparison).data());
  if (words.as_json) fmt::print("{}\n", json_of(comparison, tolerance).dump(2));
  else print(comparison, tolerance);
  constexpr int kBeyond = 3;
  if (!comparison.within(tolerance)) throw CLI::RuntimeError(kBeyond);
}

}  // namespace

void add_compare(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("compare",
                         "Hit mask, colour and all layers of two EXR pictures; exit code 3 where "
                         "they differ by more than --tolerance (cost and certificate may)");
  const auto words = std::make_shared<CompareWords>();
  verb->add_option("A", words->a, "An .exr picture")->required();
  verb->add_option("B", words->b, "Another one of the same size")->required();
  verb->add_option("--tolerance", words->tolerance,
                   "How much a number may differ: depth and z in world units, normals in radians, colour in "
                   "linear units "
                   "(default 0); the same pixels must be hit in any case");
  verb->add_option("-o", words->output,
                   "A picture of the differences, .png: of the first layer that both have, red and blue "
                   "where only A or B is hit");
  verb->add_flag("--json", words->as_json, "One JSON object on stdout");
  verb->callback([words] { run(*words); });
}

}  // namespace isocast::verbs
