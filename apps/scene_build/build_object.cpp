#include <fmt/format.h>
#include <isocast/apps/scene_build/build_object.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/implicit/automatic.h>
#include <isocast/implicit/formula_region.h>
#include <isocast/ray/clipped_surface.h>
#include <isocast/volume/statistics.h>

#include <chrono>

namespace isocast {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::vector<double> best_iso(const Volume& volume, const std::filesystem::path& file) {
  const VolumeStatistics statistics = statistics_of(volume);
  check_mapped_files();
  if (statistics.suggested_iso.empty())
    throw InputError(fmt::format(
        "{}: no iso-value suggests itself (it has no two different finite values); give one with --iso",
        file.string()));
  return {statistics.suggested_iso.front()};
}

using Clock = std::chrono::steady_clock;

// What is used goes to the features, the rest to what was left out.
void list(BuiltObject& built, bool used, const char* name) {
  (used ? built.features : built.left_out).push_back(name);
}

// Whether a method has the precision that is asked for.
void check_precision(const Method& method, const EvaluationSettings& settings) {
  if (settings.mixed_precision && method.precisions.find("mixed") == std::string_view::npos)
    throw InputError(
        fmt::format("--precision mixed: the method {} has only {}", method.name, method.precisions));
}

// A surface made with these options, which its iso-values and its method may change in later. choose: the
// row of the method table.
template <class SurfaceKind, class Options, class Choose>
void use(ObjectSurface& object, const std::shared_ptr<SurfaceKind>& surface, const Options& options,
         Choose choose) {
  BuiltObject& built = object.built;
  object.surface = surface;
  built.iso = options.iso;
  built.proves = surface->proves();
  const auto current = std::make_shared<Options>(options);
  built.move_surface = [=](const std::vector<double>& iso) {
    current->iso = iso;
    surface->set_options(*current);
  };
  built.change_method = [=](const std::string& name, const std::map<std::string, std::string>& settings,
                            const EvaluationSettings& evaluation) {
    current->method = choose(name, settings);
    current->double_precision = evaluation.double_precision;
    current->isa = evaluation.isa;
    surface->set_options(*current);
  };
}

void build(ObjectSurface& object, const VolumeSource& source, const ObjectDescription& wanted,
           const EvaluationSettings& settings) {
  BuiltObject& built = object.built;
  VolumeSurfaceOptions options;
  options.object = static_cast<std::uint16_t>(built.place);
  options.method = choose_cell_method(wanted.method, wanted.settings);
  options.double_precision = settings.double_precision;
  options.isa = settings.isa;
  options.normals = wanted.normals;
  const Method& method = volume_methods()[static_cast<std::size_t>(options.method.method)];
  check_precision(method, settings);
  built.method = std::string(method.name);
  if (wanted.method == "auto")
    built.method_reason = "the first root of the exact cubic, isolated: right and fastest of those that are";

  auto start = Clock::now();
  const auto volume = std::make_shared<const Volume>(read_volume(source.file, source.read));
  options.iso = wanted.iso.empty() ? best_iso(*volume, source.file) : wanted.iso;
  built.load_ms = ms_since(start);

  start = Clock::now();
  const auto surface = std::make_shared<VolumeSurface>(volume, options);
  built.build_ms = ms_since(start);
  built.volume = volume;
  built.volume_bytes = volume->bytes();
  built.acceleration_bytes = static_cast<std::int64_t>(surface->acceleration_bytes());
  use(object, surface, options, choose_cell_method);

  built.features = {"volume", fmt::format("iso:{}", options.iso.size()),
                    fmt::format("format:{}", volume->format)};
  list(built, volume->tree != nullptr, "sparse tree");
  list(built, volume->tree == nullptr, "macrocells");
  list(built, volume->mapped, "memory mapping");
  list(built, !volume->mapped, "copy of the samples");
  list(built, wanted.iso.empty(), "statistics");
  list(built, volume->format == "nifti", "module:nifti");
  list(built, volume->format == "vdb", "process:openvdb");
}

void build(ObjectSurface& object, const FormulaSource& source, const ObjectDescription& wanted,
           const EvaluationSettings& settings) {
  BuiltObject& built = object.built;
  ImplicitSurfaceOptions options;
  options.object = static_cast<std::uint16_t>(built.place);
  const bool automatic = wanted.method == "auto";
  options.method = choose_formula_method(automatic ? "affine" : wanted.method, wanted.settings);
  options.double_precision = settings.double_precision;
  options.mixed_precision = settings.mixed_precision;
  options.isa = settings.isa;
  options.time = source.time;
  options.normals = wanted.normals;
  options.components = wanted.by_component;
  if (!wanted.iso.empty()) options.iso = wanted.iso;
  if (automatic) {
    const AutomaticMethod choice = choose_automatically(source.expression, source.domain, options);
    options.method.method = choice.method, options.method.pass = choice.pass;
    built.method_reason = choice.reason;
  }
  const Method& method = find_method(formula_methods(), name_of(options.method));
  check_precision(method, settings);
  built.method = std::string(method.name);

  const auto start = Clock::now();
  const auto surface = std::make_shared<ImplicitSurface>(source.expression, source.domain, options);
  built.build_ms = ms_since(start);
  use(object, surface, options, choose_formula_method);
  built.features = {"formula", fmt::format("iso:{}", options.iso.size())};
  if (wanted.by_component) built.components = static_cast<std::size_t>(surface->component_count());
  list(built, wanted.by_component, "components");
  for (const char* part : {"volume", "acceleration structure", "statistics"}) list(built, false, part);
}

template <class Source>
void build(ObjectSurface& object, const Source& /*source*/, const ObjectDescription& /*wanted*/,
           const EvaluationSettings& /*settings*/) {
  throw InputError(fmt::format("object '{}': this kind of object cannot be rendered yet", object.built.name));
}

void clip(ObjectSurface& object, const std::vector<SolidDescription>& solids) {
  list(object.built, !solids.empty(), "clip solids");
  if (solids.empty()) return;
  std::vector<std::shared_ptr<const Region>> regions;
  for (const SolidDescription& solid : solids)
    regions.push_back(std::make_shared<FormulaRegion>(solid.formula, solid.time));
  object.surface = std::make_shared<ClippedSurface>(object.surface, std::move(regions),
                                                    static_cast<std::uint16_t>(object.built.place));
}

}  // namespace

ObjectSurface build_object(const ObjectDescription& description, const EvaluationSettings& settings,
                           std::uint16_t number) {
  ObjectSurface object;
  object.built.name = description.name;
  object.built.place = number;
  std::visit([&](const auto& source) { build(object, source, description, settings); }, description.source);
  clip(object, description.clips);
  return object;
}

}  // namespace isocast
