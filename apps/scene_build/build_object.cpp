#include <fmt/format.h>
#include <isocast/apps/scene_build/build_csg.h>
#include <isocast/apps/scene_build/build_object.h>
#include <isocast/apps/scene_build/moved.h>
#include <isocast/base/error.h>
#include <isocast/implicit/automatic.h>
#include <isocast/implicit/formula_region.h>
#include <isocast/ray/clipped_surface.h>
#include <isocast/ray/transformed_surface.h>
#include <isocast/scene/mesh/mesh_surface.h>

#include <chrono>

namespace isocast {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

std::vector<double> best_iso(const VolumeSource& source, VolumeLibrary& library) {
  const auto statistics = library.statistics(source);
  if (statistics->suggested_iso.empty())
    throw InputError(fmt::format(
        "{}: no iso-value suggests itself (it has no two different finite values); give one with --iso",
        source.file.string()));
  return {statistics->suggested_iso.front()};
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

void use_evaluation(const EvaluationSettings& evaluation, VolumeSurfaceOptions& options) {
  options.double_precision = evaluation.double_precision;
  options.isa = evaluation.isa;
  options.device = evaluation.device ? evaluation.device->volumes : nullptr;
}
void use_evaluation(const EvaluationSettings& evaluation, ImplicitSurfaceOptions& options) {
  options.double_precision = evaluation.double_precision;
  options.mixed_precision = evaluation.mixed_precision;
  options.isa = evaluation.isa;
  options.device = evaluation.device ? evaluation.device->formulas : nullptr;
}

// A surface made with these options, which its iso-values and its method may change in later. choose: the
// row of the method table. Returns the options as they are at any time.
template <class SurfaceKind, class Options, class Choose>
std::shared_ptr<Options> use(ObjectSurface& object, const std::shared_ptr<SurfaceKind>& surface,
                             const Options& options, Choose choose) {
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
    use_evaluation(evaluation, *current);
    surface->set_options(*current);
  };
  return current;
}

void build(ObjectSurface& object, const VolumeSource& source, const ObjectDescription& wanted,
           const BuildContext& context) {
  const EvaluationSettings& settings = context.settings;
  BuiltObject& built = object.built;
  VolumeSurfaceOptions options;
  options.object = context.number;
  options.method = choose_cell_method(wanted.method, wanted.settings);
  use_evaluation(settings, options);
  options.normals = wanted.normals;
  const Method& method = volume_methods()[static_cast<std::size_t>(options.method.method)];
  check_precision(method, settings);
  built.method = std::string(method.name);
  if (wanted.method == "auto")
    built.method_reason = "the first root of the exact cubic, isolated: right and fastest of those that are";

  auto start = Clock::now();
  const auto volume = moved(context.library.get(source), wanted.place);
  options.iso = wanted.iso.empty() ? best_iso(source, context.library) : wanted.iso;
  built.load_ms = ms_since(start);

  start = Clock::now();
  const auto surface = std::make_shared<VolumeSurface>(volume, options);
  built.build_ms = ms_since(start);
  built.volume = volume;
  built.volume_bytes = volume->bytes();
  built.acceleration_bytes = static_cast<std::int64_t>(surface->acceleration_bytes());
  built.mask_use = [surface] { return surface->mask_use(); };
  use(object, surface, options, choose_cell_method);
  object.above = true;
  if (!volume->tree)
    object.solid = {
        {{0, 0, 0}, {double(volume->dims[0] - 1), double(volume->dims[1] - 1), double(volume->dims[2] - 1)}},
        volume->world_from_grid};

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
           const BuildContext& context) {
  const EvaluationSettings& settings = context.settings;
  BuiltObject& built = object.built;
  ImplicitSurfaceOptions options;
  options.object = context.number;
  const bool automatic = wanted.method == "auto";
  options.method = choose_formula_method(automatic ? "affine" : wanted.method, wanted.settings);
  use_evaluation(settings, options);
  options.time = source.time;
  options.normals = wanted.normals;
  options.components = wanted.by_component;
  if (!wanted.iso.empty()) options.iso = wanted.iso;
  const auto choose = [expression = source.expression, domain = source.domain,
                       plain = options.method](ImplicitSurfaceOptions& now) {
    now.method = plain;
    const AutomaticMethod choice = choose_automatically(expression, domain, now);
    now.method.method = choice.method, now.method.pass = choice.pass;
    return choice.reason;
  };
  if (automatic) built.method_reason = choose(options);
  const Method& method = find_method(formula_methods(), name_of(options.method));
  check_precision(method, settings);
  built.method = std::string(method.name);

  const auto start = Clock::now();
  const auto surface = std::make_shared<ImplicitSurface>(source.expression, source.domain, options);
  built.build_ms = ms_since(start);
  const auto current = use(object, surface, options, choose_formula_method);
  if (automatic)
    built.choose_method = [=] {
      choose(*current);
      surface->set_options(*current);
      return std::string(name_of(current->method));
    };
  object.solid = {{source.domain.lo, source.domain.hi}, wanted.place};
  if (!is_identity(wanted.place))
    object.surface =
        std::make_shared<TransformedSurface>(object.surface, wanted.place, context.number, context.number);
  built.features = {"formula", fmt::format("iso:{}", options.iso.size())};
  if (wanted.by_component) built.components = static_cast<std::size_t>(surface->component_count());
  list(built, wanted.by_component, "components");
  for (const char* part : {"volume", "acceleration structure", "statistics"}) list(built, false, part);
}

void build(ObjectSurface& object, const MeshSource& source, const ObjectDescription& wanted,
           const BuildContext& context) {
  BuiltObject& built = object.built;
  auto start = Clock::now();
  Mesh mesh = read_mesh(source.file);
  move(mesh, wanted.place);
  built.load_ms = ms_since(start);
  start = Clock::now();
  const auto surface = std::make_shared<MeshSurface>(std::move(mesh), context.settings.isa, context.number);
  built.build_ms = ms_since(start);
  built.method = "triangles";
  built.iso = {0};
  built.volume_bytes = static_cast<std::int64_t>(surface->bytes());
  built.acceleration_bytes = static_cast<std::int64_t>(surface->acceleration_bytes());
  object.surface = surface;
  built.features = {"mesh", fmt::format("triangles:{}", surface->triangle_count()), "box tree"};
  list(built, has_embree(), "module:embree");
}

void build(ObjectSurface& object, const CsgSource& source, const ObjectDescription& wanted,
           const BuildContext& context) {
  build_csg(object, source, wanted, context);
}

void build(ObjectSurface& object, const InstanceSource& /*source*/, const ObjectDescription& /*wanted*/,
           const BuildContext& /*context*/) {
  throw InputError(fmt::format("object '{}': an instance cannot be an operand", object.built.name));
}

}  // namespace

std::vector<std::shared_ptr<const Surface>> clipped(
    const std::vector<std::shared_ptr<const Surface>>& surfaces, const std::vector<SolidDescription>& solids,
    std::size_t place) {
  if (solids.empty()) return surfaces;
  std::vector<std::shared_ptr<const Region>> regions;
  for (const SolidDescription& solid : solids)
    regions.push_back(std::make_shared<FormulaRegion>(solid.formula, solid.time));
  std::vector<std::shared_ptr<const Surface>> cut;
  for (const auto& surface : surfaces)
    cut.push_back(
        std::make_shared<ClippedSurface>(surface, regions, static_cast<std::uint16_t>(place + cut.size())));
  return cut;
}

ObjectSurface build_object(const ObjectDescription& description, const BuildContext& context) {
  ObjectSurface object;
  object.built.name = description.name;
  object.built.place = context.number;
  std::visit([&](const auto& source) { build(object, source, description, context); }, description.source);
  list(object.built, !description.clips.empty(), "clip solids");
  object.built.unclipped = {object.surface};
  object.surface = clipped(object.built.unclipped, description.clips, context.number).front();
  const BuiltObject& built = object.built;
  if (object.materials.empty())
    object.materials =
        materials_of(description.materials, built.components > 0 ? built.components : built.iso.size());
  return object;
}

std::vector<Material> materials_of(const MaterialDescription& description, std::size_t count) {
  std::vector<Material> materials;
  for (std::size_t i = 0; i < count; ++i) materials.push_back(material_of(description, i));
  return materials;
}

}  // namespace isocast
