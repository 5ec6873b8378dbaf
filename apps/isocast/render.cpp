// isocast render: a picture of the iso-surfaces of a volume or a formula.
#include <fmt/format.h>
#include <isocast/apps/isocast/formula_input.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/stats.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/isocast/volume_options.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <isocast/render/render.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <optional>

namespace isocast::verbs {
namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The command line as it was typed.
struct Words {
  std::string input, output, iso, iso_sweep, colors, method = "auto", size = "1024x1024", isa = "auto",
                                                     precision = "float";
  std::string position, target, up, fov, ortho, normals = "gradient", light, aov, stats;
  std::string domain, time;
  std::vector<std::string> set, params;
  bool shadows = false;
  int spp = 1, threads = 0;
  ReadOptions read;
};

std::optional<Double3> parse_vector(const std::string& text, const char* option) {
  if (text.empty()) return std::nullopt;
  const std::vector<double> v = parse_numbers(text, option);
  if (v.size() != 3) throw InputError(fmt::format("{} {}: expected three numbers X,Y,Z", option, text));
  return Double3{v[0], v[1], v[2]};
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

// The iso-values of every frame: one frame of all of --iso, or one value a frame.
std::vector<std::vector<double>> parse_frames(const Words& words) {
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

std::variant<VolumeSource, FormulaSource> find_source(const Words& words) {
  FormulaRequest request{words.input, parse_parameters(words.params, "--param"), {}};
  if (is_volume_file(words.input, request.parameters)) {
    if (!words.params.empty() || !words.domain.empty() || !words.time.empty())
      throw InputError("found --param, --domain or --time for a volume, expected them for a formula");
    return VolumeSource{words.input, words.read};
  }
  if (words.normals == "difference")
    throw InputError("found --normals difference for a formula, whose gradient is exact");
  if (!words.domain.empty()) request.domain = parse_domain(words.domain, "--domain");
  FormulaInput input = read_formula(request);
  return FormulaSource{std::move(input.expression), input.domain,
                       words.time.empty() ? 0 : parse_number(words.time, "--time")};
}

SceneDescription describe(const Words& words) {
  SceneDescription scene;
  ObjectDescription& object = scene.object;
  object.source = find_source(words);
  object.method = words.method;
  for (const std::string& word : words.set) object.settings.insert(parse_key_value(word, "--set"));
  if (!words.colors.empty())
    for (const std::string& color : split(words.colors, ',')) object.colors.push_back(color_from_hex(color));
  object.normals = words.normals == "difference" ? NormalKind::difference : NormalKind::gradient;
  scene.camera = {parse_vector(words.position, "--camera-position"),
                  parse_vector(words.target, "--camera-target"), parse_vector(words.up, "--camera-up"),
                  std::nullopt, std::nullopt};
  if (!words.fov.empty()) scene.camera.fov = parse_number(words.fov, "--fov");
  if (!words.ortho.empty()) scene.camera.ortho_height = parse_number(words.ortho, "--ortho");
  scene.light = parse_vector(words.light, "--light");
  if (scene.light && length(*scene.light) == 0)
    throw InputError("--light 0,0,0: expected a direction towards the light");
  scene.shadows = words.shadows;
  return scene;
}

std::vector<Layer> parse_layers(const Words& words, bool exr) {
  std::vector<Layer> layers;
  if (words.aov.empty()) return layers;
  if (!exr)
    throw InputError(fmt::format("--aov {}: layers need an .exr file, {} is none", words.aov, words.output));
  for (const std::string& name : split(words.aov, ',')) { layers.push_back(layer_from_name(name)); }
  return layers;
}

// out.png -> out_0003.png when there are several frames
fs::path frame_path(const fs::path& output, std::size_t frame, std::size_t frames) {
  if (frames == 1) return output;
  return output.parent_path() /
         fmt::format("{}_{:04}{}", output.stem().string(), frame, output.extension().string());
}

void write_stats(const std::string& where, const std::string& text) {
  if (where == "-") fmt::print("{}", text);
  else write_text_file(where, text);
}

void run(const Words& words) {
  const Clock::time_point start = Clock::now();
  const std::string extension = fs::path(words.output).extension().string();
  const bool exr = extension == ".exr";
  if (!exr && extension != ".png")
    throw InputError(fmt::format("-o {}: expected a name that ends with .png or .exr", words.output));
  if (words.precision == "mixed")
    throw InputError("--precision mixed: volumes and formulas are solved in float or double");
  const auto [width, height] = parse_size(words.size);
  const std::vector<Layer> layers = parse_layers(words, exr);
  const std::vector<std::vector<double>> frames = parse_frames(words);
  SceneDescription description = describe(words);
  description.object.iso = frames.front();
  const EvaluationSettings evaluation{isa_from_name(words.isa), words.precision == "double"};
  const int threads = words.threads > 0 ? words.threads : oneapi::tbb::info::default_concurrency();
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
  // a bad name fails before the work
  { const OutputFile writable(frame_path(words.output, 0, frames.size())); }
  if (!words.stats.empty() && words.stats != "-") { const OutputFile writable(words.stats); }

  BuiltScene built = build_scene(description, evaluation);
  if (!built.proves && std::ranges::find(layers, Layer::certificate) != layers.end())
    throw InputError(fmt::format(
        "--aov certificate: the method {} proves nothing ('isocast methods' says which do)", built.method));
  const View view(frame(built.scene.bounds(), description.camera, double(width) / height), width, height);
  RenderSettings settings;
  settings.spp = words.spp;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0) built.set_iso(frames[i], description.object.colors);
    Film film(width, height, layers);
    const Clock::time_point render_start = Clock::now();
    RenderCounts counts;
    {
      Progress progress("rendering", tile_count(view));
      counts = render(built.scene, view, settings, film, interrupt_token(), &progress);
    }
    const double render_ms = ms_since(render_start);
    const Clock::time_point write_start = Clock::now();
    const fs::path path = frame_path(words.output, i, frames.size());
    if (exr) write_exr(path, width, height, image_layers(film));
    else write_png(path, width, height, film.color().data());
    const double write_ms = ms_since(write_start);
    if (words.stats.empty()) continue;
    const FrameReport report{built,
                             find_features(built.scene, film, settings),
                             counts,
                             std::string(name_of(evaluation.isa)),
                             evaluation.double_precision,
                             threads,
                             width,
                             height,
                             words.spp,
                             render_ms,
                             write_ms,
                             ms_since(start)};
    write_stats(frames.size() == 1 || words.stats == "-" ? words.stats
                                                         : frame_path(words.stats, i, frames.size()).string(),
                stats_json(report, ISOCAST_VERSION));
  }
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "render", "Pictures of iso-surfaces of a volume or a formula: PNG, or EXR with layers");
  const auto w = std::make_shared<Words>();
  verb->add_option("INPUT", w->input,
                   "A volume file, a formula of x y z w, a .vm tape, or @id of the catalogue")
      ->required();
  verb->add_option("-o", w->output, "The picture: .png (sRGB) or .exr (linear, with layers)")->required();
  verb->add_option(
      "--iso", w->iso,
      "Iso-values V[,V...] in the file's units (default: the best of suggested_iso; 0 for formulas)");
  verb->add_option("--iso-sweep", w->iso_sweep,
                   "FROM:TO:COUNT, a frame per value: OUT_0000.png, OUT_0001.png, ...");
  verb->add_option("--colors", w->colors, "A colour per iso-value: #rrggbb[,#rrggbb...]");
  verb->add_option("--param", w->params, "A parameter of the formula, such as a=2")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  verb->add_option("--domain", w->domain,
                   "Box of a formula: LO,HI or XLO,XHI,YLO,YHI,ZLO,ZHI (default: -1,1, or the catalogue's)");
  verb->add_option("--time", w->time, "The variable w of a formula (default 0)");
  verb->add_option("--method", w->method,
                   "auto (marmitt for volumes, interval or affine for formulas), or a name that 'isocast methods' lists");
  verb->add_option("--set", w->set, "An option of the method, KEY=VALUE")->allow_extra_args(false);
  verb->add_option("--size", w->size, "WIDTHxHEIGHT in pixels (default 1024x1024)");
  verb->add_option("--spp", w->spp,
                   "Samples per pixel for the colour; layers are those of the centre (default 1)")
      ->check(CLI::Range(1, 4096));
  verb->add_option("--camera-position", w->position, "X,Y,Z in world units (default: frames the volume)");
  verb->add_option("--camera-target", w->target, "X,Y,Z in world units");
  verb->add_option("--camera-up", w->up, "X,Y,Z (default 0,0,1)");
  CLI::Option* fov = verb->add_option("--fov", w->fov, "Vertical field of view in degrees (default 45)");
  verb->add_option("--ortho", w->ortho, "Orthographic camera: height of the picture in world units")
      ->excludes(fov);
  verb->add_option("--light", w->light,
                   "X,Y,Z: direction towards a directional light (default: a headlight)");
  verb->add_flag("--shadows", w->shadows, "Hard shadows of the directional light");
  verb->add_option("--normals", w->normals,
                   "gradient (of the cell, exact) or difference (central differences, smooth)")
      ->check(CLI::IsMember({"gradient", "difference"}));
  verb->add_option("--aov", w->aov, "Layers of the EXR: depth,z,normal,position,id,value,cost,certificate");
  verb->add_option("--isa", w->isa, "auto, scalar, sse4, avx2 or avx512: the same picture with each");
  verb->add_option("--precision", w->precision, "float (default) or double")
      ->check(CLI::IsMember({"float", "double", "mixed"}));
  verb->add_option("--threads", w->threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
  verb->add_option("--stats", w->stats, "What was done, as JSON, to a file or - for stdout");
  add_read_options(*verb, w->read);
  verb->callback([w] { run(*w); });
}

}  // namespace isocast::verbs
