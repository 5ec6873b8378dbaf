#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/data_gen/hash.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/data_gen/vessel.h>
#include <isocast/implicit/expression/nearest_name.h>
#include <isocast/implicit/expression/parse.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isocast {
namespace {

// A formula whose parameters are the settings.
Field formula_volume(std::string_view formula, const TestVolumeSettings& settings) {
  Parameters parameters;
  for (const auto& [name, value] : settings) parameters.push_back({name, shortest_constant(value)});
  return formula_field(parse_expression(formula, parameters));
}

// S. R. Marschner, R. J. Lobb: An evaluation of reconstruction filters for volume rendering, Visualization
// 1994.
Field marschner_lobb(const TestVolumeSettings& settings) {
  return formula_volume(
      "(1 - sin(pi*z/2) + alpha*(1 + cos(2*pi*fM*cos(pi*sqrt(x^2 + y^2)/2))))/(2*(1 + alpha))", settings);
}

Field gyroid(const TestVolumeSettings& settings) {
  return formula_volume(
      "sin(pi*periods*x)*cos(pi*periods*y) + sin(pi*periods*y)*cos(pi*periods*z) + "
      "sin(pi*periods*z)*cos(pi*periods*x)",
      settings);
}

Field constant(const TestVolumeSettings& settings) { return formula_volume("value", settings); }

// A setting that has to be a whole number from lo to hi.
std::int64_t whole(const TestVolumeSettings& settings, std::string_view name, double lo, double hi) {
  const double value = settings.find(name)->second;
  if (value != std::floor(value) || value < lo || value > hi)
    throw InputError(
        fmt::format("found {} = {}, expected a whole number from {} to {}", name, value, lo, hi));
  return static_cast<std::int64_t>(value);
}

constexpr double kMaxSeed = 0x1p53;

Field noise(const TestVolumeSettings& settings) {
  const auto seed = static_cast<std::uint64_t>(whole(settings, "seed", 0, kMaxSeed));
  return [seed](const SampleGrid&, std::int64_t j, std::int64_t k, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = hash_uniform({seed, i, static_cast<std::uint64_t>(j), static_cast<std::uint64_t>(k)});
  };
}

Field vessel(const TestVolumeSettings& settings) {
  const auto seed = static_cast<std::uint64_t>(whole(settings, "seed", 0, kMaxSeed));
  return vessel_field(seed, static_cast<int>(whole(settings, "levels", 0, 10)));
}

Field checkerboard(const TestVolumeSettings&) {
  return [](const SampleGrid&, std::int64_t j, std::int64_t k, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>((static_cast<std::int64_t>(i) + j + k) % 2);
  };
}

constexpr TestVolumeOption kMarschnerLobb[] = {{"fM", 6, "frequency of the ripples"},
                                               {"alpha", 0.25, "their height"}};
constexpr TestVolumeOption kGyroid[] = {{"periods", 4, "along the edge of [-1,1]^3"}};
constexpr TestVolumeOption kNoise[] = {{"seed", 1, "of the random numbers"}};
constexpr TestVolumeOption kVessel[] = {{"seed", 1, "of the random numbers"},
                                        {"levels", 6, "forks from trunk to tip"}};
constexpr TestVolumeOption kConstant[] = {{"value", 0.5, "everywhere"}};

constexpr TestVolume kTestVolumes[] = {
    {"marschner_lobb", "the ripples that reconstruction is judged by", kMarschnerLobb, marschner_lobb},
    {"gyroid", "a periodic surface that fills space", kGyroid, gyroid},
    {"noise", "uniform in [0,1), each voxel for itself", kNoise, noise},
    {"vessel", "a branching tree of tubes, walls at 0.5", kVessel, vessel},
    {"checkerboard", "0 and 1 by turns, voxel by voxel", {}, checkerboard},
    {"constant", "the same value everywhere", kConstant, constant},
};

}  // namespace

std::span<const TestVolume> test_volumes() { return kTestVolumes; }

const TestVolume* find_test_volume(std::string_view name) {
  const auto found = std::ranges::find(kTestVolumes, name, &TestVolume::name);
  return found == std::end(kTestVolumes) ? nullptr : found;
}

Field test_volume_field(const TestVolume& volume, const TestVolumeSettings& settings) {
  // defaults for what is not set
  TestVolumeSettings complete = settings;
  std::vector<std::string> names;
  for (const TestVolumeOption& option : volume.options) {
    names.emplace_back(option.name);
    complete.emplace(option.name, option.default_value);
  }

  // nothing that the volume does not know
  for (const auto& [name, value] : settings)
    if (std::ranges::count(names, name) == 0)
      throw InputError(fmt::format("found the setting {}, expected {} of the test volume {}", in_quotes(name),
                                   names.empty() ? "none" : fmt::format("one of {}", fmt::join(names, " ")),
                                   volume.name));
  return volume.make(complete);
}

}  // namespace isocast
