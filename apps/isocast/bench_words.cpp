#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/suites.h>
#include <isocast/apps/isocast/bench_words.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/reference/reference_cache.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <filesystem>

namespace isocast::verbs {
namespace {

using namespace bench;

// The suites that always run all methods; `all` holds pictures, too.
constexpr std::string_view kRowSuites[] = {"cells", "evaluate", "frames", "stability", "papers", "all"};

bool is_row_suite(const std::string& word) {
  return std::ranges::find(kRowSuites, word) != std::end(kRowSuites);
}
bool is_suite(const std::string& word) { return word.empty() || is_row_suite(word) || find_suite(word); }

std::string suite_names() {
  std::vector<std::string_view> names(std::begin(kRowSuites), std::end(kRowSuites));
  for (const PictureSuite& suite : picture_suites()) names.push_back(suite.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// A picture of what the user named.
PictureCase input_case(const BenchWords& words) {
  constexpr int kMostRays = 1 << 20;
  RenderWords scene = words.scene;
  if (scene.size.empty()) scene.size = "128x128";
  const auto [width, height] = parse_size(scene.size);
  if (std::int64_t{width} * height > kMostRays)
    throw InputError(fmt::format("--size {}: found {} rays, expected at most {}", scene.size,
                                 std::int64_t{width} * height, kMostRays));
  PictureCase picture{"input", typed_formula(scene.input), {}, width, height};
  try {
    picture.scene = describe(scene);
    if (picture.scene.objects.size() > 1)
      throw InputError(fmt::format("{}: found several objects, expected a scene of one", picture.name));
  } catch (const InputError& error) {
    const bool a_word = std::ranges::all_of(picture.name, [](unsigned char c) { return std::isalpha(c); });
    if (!a_word) throw;
    throw InputError(fmt::format("'{}' is no suite (these are {}), and as a formula: {}", picture.name,
                                 suite_names(), error.what()));
  }
  if (!scene.iso.empty()) picture.scene.objects.front().iso = parse_numbers(scene.iso, "--iso");
  if (std::holds_alternative<VolumeSource>(picture.scene.objects.front().source))
    picture.name = std::filesystem::path(picture.name).filename().string();
  return picture;
}

}  // namespace

void check(const BenchWords& words) {
  const RenderWords& s = words.scene;
  if (!s.set.empty() && s.method == "auto")
    throw InputError("found --set without --method, expected the methods that have the option");
  if (!words.data.empty() && s.input != "papers" && s.input != "all")
    throw InputError("found --data, expected it with the suites papers and all only");
  if (!words.data.empty() && !std::filesystem::is_directory(words.data))
    throw InputError(fmt::format("--data: found no folder '{}'", words.data));
  if (s.input == "papers" && !s.isa.empty())
    throw InputError("found --isa with the suite papers, which times what its tables need");
  if (s.isa == "cuda" && (is_row_suite(s.input) || s.input == "all"))
    throw InputError(
        fmt::format("--isa cuda: found the suite {}, expected an INPUT or a suite of pictures", s.input));
  if (!is_suite(s.input)) return;
  const std::pair<const char*, const std::string&> of_inputs[] = {{"--iso", s.iso},
                                                                  {"--domain", s.domain},
                                                                  {"--time", s.time},
                                                                  {"--size", s.size},
                                                                  {"--camera-position", s.position},
                                                                  {"--camera-target", s.target},
                                                                  {"--camera-up", s.up},
                                                                  {"--fov", s.fov},
                                                                  {"--ortho", s.ortho}};
  for (const auto& [option, word] : of_inputs)
    if (!word.empty())
      throw InputError(fmt::format("found {} with a suite, expected it with an INPUT", option));
  if (!s.params.empty()) throw InputError("found --param with a suite, expected it with an INPUT");
  if (is_row_suite(s.input) && (!words.precision.empty() || s.method != "auto"))
    throw InputError(
        fmt::format("found --precision or --method with the suite {}, which always runs all", s.input));
}

std::vector<Isa> isas_of(const BenchWords& words) {
  return words.scene.isa.empty() || words.scene.isa == "cuda" ? available_isas()
                                                              : std::vector{isa_from_name(words.scene.isa)};
}

bool has_pictures(const BenchWords& words) {
  return words.scene.input == "all" || !is_row_suite(words.scene.input);
}

std::filesystem::path cache_of(const BenchWords& words) {
  if (words.cache == "none") return {};
  return words.cache.empty() ? reference::default_cache_folder() : std::filesystem::path(words.cache);
}

PictureOptions picture_options(const BenchWords& words) {
  PictureOptions options;
  options.isas = isas_of(words);
  if (words.scene.isa == "cuda") options.device = evaluation_from("cuda", "float").device;
  if (words.scene.method != "auto") options.settings.wanted = split(words.scene.method, ',');
  for (const std::string& word : words.scene.set) options.settings.set.insert(parse_key_value(word, "--set"));
  options.settings.quick = words.quick;
  if (!words.precision.empty()) options.precisions = {words.precision};
  options.repetitions = words.quick ? Repetitions(3, 9, 2.0) : options.repetitions;
  options.cache = cache_of(words);
  return options;
}

std::vector<PictureCase> picture_cases(const BenchWords& words) {
  if (!is_suite(words.scene.input)) return {input_case(words)};
  std::vector<PictureCase> cases;
  for (const PictureSuite& suite : picture_suites())
    if (words.scene.input.empty() || words.scene.input == "all" || words.scene.input == suite.name)
      for (PictureCase& picture : suite.cases({words.quick, words.folder}))
        cases.push_back(std::move(picture));
  return cases;
}

}  // namespace isocast::verbs
