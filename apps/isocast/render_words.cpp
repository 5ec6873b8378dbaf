#include <fmt/format.h>
#include <isocast/apps/isocast/formula_input.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/render_words.h>
#include <isocast/base/error.h>

#include <cmath>
#include <optional>

namespace isocast {
namespace {

std::optional<Double3> parse_vector(const std::string& text, const char* option) {
  if (text.empty()) return std::nullopt;
  const std::vector<double> v = parse_numbers(text, option);
  if (v.size() != 3) throw InputError(fmt::format("{} {}: expected three numbers X,Y,Z", option, text));
  return Double3{v[0], v[1], v[2]};
}

double parse_time(const RenderWords& words) {
  return words.time.empty() ? 0 : parse_number(words.time, "--time");
}

std::variant<VolumeSource, FormulaSource> find_source(const RenderWords& words) {
  FormulaRequest request{words.input, parse_parameters(words.params, "--param"), {}};
  if (is_volume_file(words.input, request.parameters)) {
    if (!words.domain.empty() || (words.clips.empty() && (!words.params.empty() || !words.time.empty())))
      throw InputError("found --param, --domain or --time for a volume, expected them for a formula");
    return VolumeSource{words.input, words.read};
  }
  if (!words.domain.empty()) request.domain = parse_domain(words.domain, "--domain");
  FormulaInput input = read_formula(request);
  return FormulaSource{std::move(input.expression), input.domain, parse_time(words)};
}

std::vector<double> parse_shares(const std::string& text, const char* option) {
  if (text.empty()) return {};
  std::vector<double> shares = parse_numbers(text, option);
  for (const double share : shares)
    if (!(share >= 0 && share <= 1))
      throw InputError(fmt::format("{}: found {}, expected numbers from 0 to 1", option, share));
  return shares;
}

std::vector<Double3> parse_lights(const std::vector<std::string>& words) {
  constexpr std::size_t kMost = 8;
  if (words.size() > kMost)
    throw InputError(fmt::format("--light: found {} lights, expected at most {}", words.size(), kMost));
  std::vector<Double3> lights;
  for (const std::string& word : words) {
    const std::optional<Double3> light = parse_vector(word, "--light");
    if (!light || !(length(*light) > 0) || !std::isfinite(length(*light)))
      throw InputError(fmt::format("--light {}: expected a direction towards the light", word));
    lights.push_back(*light);
  }
  return lights;
}

NormalKind normals_from(const std::string& name) {
  return name == "difference"  ? NormalKind::difference
         : name == "neighbour" ? NormalKind::neighbour
                               : NormalKind::gradient;
}

}  // namespace

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::array<int, 2> parse_size(const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  constexpr double kLargest = 32768;
  if (parts.size() == 2) {
    const double w = parse_number(parts[0], "--size"), h = parse_number(parts[1], "--size");
    if (w >= 1 && h >= 1 && w <= kLargest && h <= kLargest && w == std::floor(w) && h == std::floor(h))
      return {static_cast<int>(w), static_cast<int>(h)};
  }
  throw InputError(
      fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each from 1 to {}", text, kLargest));
}

std::vector<std::vector<double>> parse_frames(const RenderWords& words) {
  const std::vector<double> iso =
      words.iso.empty() ? std::vector<double>{} : parse_numbers(words.iso, "--iso");
  if (words.iso_sweep.empty()) return {iso};
  if (!iso.empty()) throw InputError("--iso and --iso-sweep exclude each other");
  const std::vector<std::string> parts = split(words.iso_sweep, ':');
  const double n = parts.size() == 3 ? parse_number(parts[2], "--iso-sweep") : 0;
  if (!(n >= 1 && n <= 100000 && n == std::floor(n)))
    throw InputError(fmt::format("--iso-sweep {}: expected FROM:TO:COUNT", words.iso_sweep));
  const double from = parse_number(parts[0], "--iso-sweep"), to = parse_number(parts[1], "--iso-sweep");
  std::vector<std::vector<double>> frames;
  for (int i = 0; i < n; ++i) frames.push_back({n == 1 ? from : from + (to - from) * i / (n - 1)});
  return frames;
}

std::vector<Layer> parse_layers(const RenderWords& words, bool exr) {
  std::vector<Layer> layers;
  if (words.aov.empty()) return layers;
  if (!exr)
    throw InputError(fmt::format("--aov {}: layers need an .exr file, {} is none", words.aov, words.output));
  for (const std::string& name : split(words.aov, ',')) { layers.push_back(layer_from_name(name)); }
  return layers;
}

MaterialDescription materials_of(const RenderWords& words) {
  MaterialDescription materials;
  if (!words.colors.empty())
    for (const std::string& color : split(words.colors, ','))
      materials.colors.push_back(color_from_hex(color));
  materials.opacities = parse_shares(words.opacity, "--opacity");
  materials.reflectivities = parse_shares(words.reflectivity, "--reflectivity");
  return materials;
}

CameraWishes camera_of(const RenderWords& words) {
  CameraWishes camera{parse_vector(words.position, "--camera-position"),
                      parse_vector(words.target, "--camera-target"), parse_vector(words.up, "--camera-up"),
                      std::nullopt, std::nullopt};
  if (!words.fov.empty()) camera.fov = parse_number(words.fov, "--fov");
  if (!words.ortho.empty()) camera.ortho_height = parse_number(words.ortho, "--ortho");
  return camera;
}

EvaluationSettings evaluation_of(const RenderWords& words) {
  return {isa_from_name(words.isa), words.precision == "double", words.precision == "mixed"};
}

RenderSettings settings_of(const RenderWords& words) {
  RenderSettings settings;
  settings.spp = words.aa == "spp" && words.spp == 1 ? 4 : words.spp;
  settings.silhouettes = words.aa == "silhouette";
  settings.transparency_depth = words.transparency_depth;
  settings.reflections = words.reflections;
  return settings;
}

SceneDescription describe(const RenderWords& words) {
  SceneDescription scene;
  ObjectDescription& object = scene.objects.front();
  std::visit([&](auto&& source) { object.source = std::move(source); }, find_source(words));
  object.method = words.method;
  for (const std::string& word : words.set) object.settings.insert(parse_key_value(word, "--set"));
  object.materials = materials_of(words);
  object.by_component = words.by_component;
  if (object.by_component && !std::holds_alternative<FormulaSource>(object.source))
    throw InputError("found --color-components for a volume, expected it for a formula");
  object.normals = normals_from(words.normals);
  if (object.normals == NormalKind::neighbour && !std::holds_alternative<FormulaSource>(object.source))
    throw InputError("found --normals neighbour for a volume, expected it for a formula");
  if (words.aa == "silhouette" && !std::holds_alternative<FormulaSource>(object.source))
    throw InputError("found --aa silhouette for a volume, expected it for a formula");
  if ((words.aa == "silhouette" || words.aa == "none") && words.spp > 1)
    throw InputError(
        fmt::format("--aa {}: found --spp {}, expected one sample a pixel", words.aa, words.spp));
  for (const std::string& word : words.clips)
    object.clips.push_back(
        {parse_expression(typed_formula(word), parse_parameters(words.params, "--param"), "--clip"),
         parse_time(words)});
  scene.camera = camera_of(words);
  scene.lights = parse_lights(words.lights);
  scene.shadows = words.shadows;
  scene.environment = words.environment;
  return scene;
}

}  // namespace isocast
