#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/render_words.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/base/error.h>
#include <isocast/scene/mesh/mesh.h>

#include <algorithm>
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

// FROM:TO is for frames.
double parse_time(const RenderWords& words) {
  const bool one = !words.time.empty() && words.time.find(':') == std::string::npos;
  return one ? parse_number(words.time, "--time") : 0;
}

std::variant<VolumeSource, FormulaSource, MeshSource> find_source(const RenderWords& words) {
  if (has_mesh_extension(words.input)) {
    if (!words.params.empty() || !words.domain.empty() || !words.iso.empty() || !words.set.empty() ||
        words.method != "auto")
      throw InputError(fmt::format("found options of volumes or formulas for the mesh {}", words.input));
    return MeshSource{words.input};
  }
  FormulaRequest request{typed_formula(words.input), parse_parameters(words.params, "--param"), {}};
  if (is_volume_file(request.text, request.parameters)) {
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

// The frame that a viewer shows ("N:N"), or the first.
int frame_of(const RenderWords& words, const SceneDescription& all) {
  if (words.frames.empty()) return frames_of(all)[0];
  return static_cast<int>(parse_number(split(words.frames, ':').front(), "--frames"));
}

// The input as the only object.
ObjectDescription describe_object(const RenderWords& words) {
  ObjectDescription object;
  std::visit([&](auto&& source) { object.source = std::move(source); }, find_source(words));
  object.method = words.method;
  for (const std::string& word : words.set) object.settings.insert(parse_key_value(word, "--set"));
  object.materials = describe_materials(words);
  object.by_component = words.by_component;
  const bool formula = std::holds_alternative<FormulaSource>(object.source);
  if (object.by_component && !formula)
    throw InputError("found --color-components for a volume, expected it for a formula");
  object.normals = normals_from(words.normals);
  if (object.normals == NormalKind::neighbour && !formula)
    throw InputError("found --normals neighbour for a volume, expected it for a formula");
  for (const std::string& word : words.clips)
    object.clips.push_back(
        {parse_expression(typed_formula(word), parse_parameters(words.params, "--param"), "--clip"),
         parse_time(words)});
  return object;
}

// The scene of a file: options of objects are for scenes of one, and some for none.
SceneDescription open_scene(const RenderWords& words) {
  SceneDescription scene =
      words.scene_text.empty() ? read_scene(words.input) : scene_from_text(words.scene_text, words.input, {});
  const struct {
    bool given;
    const char *option, *key;
  } of_objects[] = {{!words.iso.empty(), "--iso", "iso"},
                    {!words.iso_sweep.empty(), "--iso-sweep", "animation.keys[].iso"},
                    {words.method != "auto", "--method", "method"},
                    {!words.set.empty(), "--set", "set"},
                    {!words.colors.empty(), "--colors", "material.color"},
                    {!words.opacity.empty(), "--opacity", "material.opacity"},
                    {!words.reflectivity.empty(), "--reflectivity", "material.reflectivity"},
                    {words.normals != "gradient", "--normals", "normals"}},
    of_files[] = {{!words.params.empty(), "--param", "params"},
                  {!words.domain.empty(), "--domain", "domain"},
                  {!words.clips.empty(), "--clip", "clip"},
                  {words.by_component, "--color-components", "color_components"},
                  {words.read.describes_raw(), "--dims, --type, --endian or --skip",
                   "dims, sample_type, endian and skip"},
                  {!words.read.grid.empty(), "--grid", "grid"}};
  const auto refuse = [&](const auto& words_of, const char* why) {
    for (const auto& word : words_of)
      if (word.given)
        throw InputError(fmt::format("found {} for {}, {}: expected the key '{}' of an object there",
                                     word.option, words.input, why, word.key));
  };
  refuse(of_files, "a scene");
  if (scene.objects.size() > 1) refuse(of_objects, "a scene of several objects");
  if (!words.camera.empty()) use_camera(scene, words.camera);
  ObjectDescription& object = scene.objects.front();
  if (words.method != "auto") object.method = words.method, object.settings.clear();
  for (const std::string& word : words.set) object.settings.insert(parse_key_value(word, "--set"));
  const MaterialDescription materials = describe_materials(words);
  if (!materials.colors.empty()) object.materials.colors = materials.colors;
  if (!materials.opacities.empty()) object.materials.opacities = materials.opacities;
  if (!materials.reflectivities.empty()) object.materials.reflectivities = materials.reflectivities;
  if (words.normals != "gradient") object.normals = normals_from(words.normals);
  return scene;
}

}  // namespace

MaterialDescription describe_materials(const RenderWords& words) {
  MaterialDescription materials;
  if (!words.colors.empty())
    for (const std::string& color : split(words.colors, ','))
      materials.colors.push_back(color_from_hex(color));
  materials.opacities = parse_shares(words.opacity, "--opacity");
  materials.reflectivities = parse_shares(words.reflectivity, "--reflectivity");
  return materials;
}

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
  if (text.empty()) return {1024, 1024};
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

std::vector<Layer> parse_layers(const RenderWords& words, bool exr) {
  std::vector<Layer> layers;
  if (words.aov.empty()) return layers;
  if (!exr)
    throw InputError(fmt::format("--aov {}: layers need an .exr file, {} is none", words.aov, words.output));
  for (const std::string& name : split(words.aov, ',')) { layers.push_back(layer_from_name(name)); }
  return layers;
}

void change_camera(const RenderWords& words, CameraWishes& camera) {
  const auto change = [](const std::optional<Double3>& point, std::optional<Double3>& to) {
    if (point) to = point;
  };
  change(parse_vector(words.position, "--camera-position"), camera.position);
  change(parse_vector(words.target, "--camera-target"), camera.target);
  change(parse_vector(words.up, "--camera-up"), camera.up);
  if (!words.fov.empty()) camera.fov = parse_number(words.fov, "--fov"), camera.ortho_height.reset();
  if (!words.ortho.empty()) camera.ortho_height = parse_number(words.ortho, "--ortho"), camera.fov.reset();
}

RenderSettings settings_of(const RenderWords& words, const RenderWishes& wishes) {
  RenderSettings settings;
  settings.spp = words.spp.value_or(words.aa == "spp" ? 4 : wishes.spp.value_or(1));
  settings.filter = filter_from_name(words.filter);
  if (settings.filter != PixelFilter::box && settings.spp == 1)
    throw InputError(
        fmt::format("--filter {}: found one sample a pixel, expected --spp above 1", words.filter));
  settings.silhouettes = words.aa == "silhouette";
  settings.coverage = words.aa == "coverage";
  settings.transparency_depth = words.transparency_depth.value_or(wishes.transparency_depth.value_or(4));
  settings.reflections = words.reflections.value_or(wishes.reflections.value_or(1));
  return settings;
}

EvaluationSettings evaluation_of(const RenderWords& words) {
  return evaluation_from(words.isa, words.precision);
}

SceneDescription describe_all(const RenderWords& words) {
  const bool from_file = is_scene_file(words.input);
  SceneDescription scene = from_file ? open_scene(words) : SceneDescription();
  if (!from_file) scene.objects.front() = describe_object(words);
  const bool formulas = std::ranges::all_of(scene.objects, [](const ObjectDescription& object) {
    return std::holds_alternative<FormulaSource>(object.source);
  });
  if (words.aa == "silhouette" && !formulas)
    throw InputError("found --aa silhouette for a volume, expected it for a formula");
  if (words.aa != "spp" && !words.aa.empty() && words.spp.value_or(1) > 1)
    throw InputError(
        fmt::format("--aa {}: found --spp {}, expected one sample a pixel", words.aa, *words.spp));
  if (!words.lights.empty()) scene.lights = parse_lights(words.lights);
  scene.shadows = scene.shadows || words.shadows;
  if (!words.environment.empty()) scene.environment = words.environment;
  if (words.ambient_occlusion > 0) scene.ambient_occlusion.samples = words.ambient_occlusion;
  if (!words.ambient_occlusion_radius.empty()) {
    const double radius = parse_number(words.ambient_occlusion_radius, "--ambient-occlusion-radius");
    if (!(radius > 0) || scene.ambient_occlusion.samples == 0)
      throw InputError(
          fmt::format("--ambient-occlusion-radius {}: expected a length above 0, with "
                      "--ambient-occlusion",
                      words.ambient_occlusion_radius));
    scene.ambient_occlusion.radius = radius;
  }
  return scene;
}

SceneDescription describe_frame(const RenderWords& words, const SceneDescription& all, const FrameJob& job) {
  SceneDescription scene = description_at(all, job.number);
  if (job.time) scene = at_time(scene, *job.time);
  if (!job.iso.empty()) scene.objects.front().iso = job.iso;
  change_camera(words, scene.camera);
  return scene;
}

SceneDescription describe(const RenderWords& words) {
  const SceneDescription all = describe_all(words);
  FrameJob job{.number = frame_of(words, all)};
  if (!words.time.empty()) job.time = parse_time(words);
  return describe_frame(words, all, job);
}

std::array<int, 2> size_of(const RenderWords& words, const SceneDescription& scene) {
  return words.size.empty() && scene.wishes.size ? *scene.wishes.size : parse_size(words.size);
}

}  // namespace isocast
