// isocast render: a picture of the iso-surfaces of a volume or a formula.
#include <fmt/format.h>
#include <isocast/apps/isocast/render_words.h>
#include <isocast/apps/isocast/scene_options.h>
#include <isocast/apps/isocast/stats.h>
#include <isocast/apps/isocast/verbs.h>
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

namespace isocast::verbs {
namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
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

void run(const RenderWords& words) {
  const Clock::time_point start = Clock::now();
  const std::string extension = fs::path(words.output).extension().string();
  const bool exr = extension == ".exr";
  if (!exr && extension != ".png")
    throw InputError(fmt::format("-o {}: expected a name that ends with .png or .exr", words.output));
  const auto [width, height] = parse_size(words.size);
  const std::vector<Layer> layers = parse_layers(words, exr);
  const std::vector<std::vector<double>> frames = parse_frames(words);
  SceneDescription description = describe(words);
  description.objects.front().iso = frames.front();
  const EvaluationSettings evaluation = evaluation_of(words);
  const int threads = words.threads > 0 ? words.threads : oneapi::tbb::info::default_concurrency();
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(threads));
  // a bad name fails before the work
  { const OutputFile writable(frame_path(words.output, 0, frames.size())); }
  if (!words.stats.empty() && words.stats != "-") { const OutputFile writable(words.stats); }

  BuiltScene built = build_scene(description, evaluation);
  if (!built.proves() && std::ranges::find(layers, Layer::certificate) != layers.end())
    throw InputError(
        fmt::format("--aov certificate: the method {} proves nothing with these options ('isocast methods' "
                    "says which do)",
                    built.objects.front().method));
  const View view(frame(built.scene.bounds(), description.camera, double(width) / height), width, height);
  const RenderSettings settings = settings_of(words);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0) built.set_iso(0, frames[i], description.objects.front().materials);
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
    const FrameReport report{built,           find_features(built.scene, film, settings),
                             counts,          std::string(name_of(evaluation.isa)),
                             words.precision, threads,
                             width,           height,
                             settings.spp,    render_ms,
                             write_ms,        ms_since(start)};
    write_stats(frames.size() == 1 || words.stats == "-" ? words.stats
                                                         : frame_path(words.stats, i, frames.size()).string(),
                stats_json(report, ISOCAST_VERSION));
  }
}

}  // namespace

void add_picture_options(CLI::App* verb, RenderWords* w) {
  add_scene_options(
      *verb, *w,
      "auto (marmitt for volumes, interval, affine or certified for formulas), or a name that 'isocast "
      "methods' lists");
  verb->add_option("--colors", w->colors, "A colour per iso-value: #rrggbb[,#rrggbb...]");
  verb->add_option("--opacity", w->opacity, "0 to 1 per iso-value, A[,A...] (default 1)");
  verb->add_option("--reflectivity", w->reflectivity,
                   "The mirrored share of the colour per iso-value, 0 to 1, R[,R...] (default 0)");
  verb->add_option("--clip", w->clips,
                   "A formula g(x,y,z): only what lies where g <= 0 is there; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FORMULA");
  verb->add_option("--spp", w->spp,
                   "Samples per pixel for the colour; layers are those of the centre (default 1)")
      ->check(CLI::Range(1, 4096));
  verb->add_option(
          "--aa", w->aa,
          "How edges are smoothed: none, spp (by --spp samples, 4 where it is not given), or silhouette "
          "(formulas: the edges between pixels are found)")
      ->check(CLI::IsMember({"none", "spp", "silhouette"}));
  verb->add_option("--light", w->lights,
                   "X,Y,Z: direction towards a directional light; up to 8 times, n lights have 1/n of the "
                   "strength each (default: a headlight)")
      ->allow_extra_args(false);
  verb->add_flag("--color-components", w->by_component,
                 "Materials belong to the operands of a formula's min and max instead of to iso-values");
  verb->add_flag("--shadows", w->shadows,
                 "Hard shadows of the directional lights; what is not opaque lets light through");
  verb->add_option(
          "--transparency-depth", w->transparency_depth,
          "Crossings that a ray passes; where more lie behind, the last counts as opaque (default 4)")
      ->check(CLI::Range(1, 64));
  verb->add_option("--reflections", w->reflections,
                   "How often a ray is mirrored where --reflectivity says so (default 1)")
      ->check(CLI::Range(0, 16));
  verb->add_option("--environment", w->environment,
                   "Picture of all directions (longitude by latitude, z up; .exr .hdr .png .jpg), seen where "
                   "nothing is hit and in reflections (default: white)");
  verb->add_option("--normals", w->normals,
                   "gradient (exact; of the cell of a volume), difference (central differences, smooth) or "
                   "neighbour (formulas: from the pixels beside it)")
      ->check(CLI::IsMember({"gradient", "difference", "neighbour"}));
  verb->add_option("--precision", w->precision, "float (default), double, or mixed (frustum methods)")
      ->check(CLI::IsMember({"float", "double", "mixed"}));
  verb->add_option("--threads", w->threads, "Number of threads (default: all)")->check(CLI::Range(1, 1024));
}

void add_render(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "render", "Pictures of iso-surfaces of a volume or a formula: PNG, or EXR with layers");
  const auto w = std::make_shared<RenderWords>();
  add_picture_options(verb, w.get());
  verb->add_option("-o", w->output, "The picture: .png (sRGB) or .exr (linear, with layers)")->required();
  verb->add_option("--iso-sweep", w->iso_sweep,
                   "FROM:TO:COUNT, a frame per value: OUT_0000.png, OUT_0001.png, ...");
  verb->add_option("--aov", w->aov, "Layers of the EXR: depth,z,normal,position,id,value,cost,certificate");
  verb->add_option("--stats", w->stats, "What was done, as JSON, to a file or - for stdout");
  verb->callback([w] { run(*w); });
}

}  // namespace isocast::verbs
