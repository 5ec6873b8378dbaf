#include <fmt/format.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
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

}  // namespace

void BuiltScene::set_iso(const std::vector<double>& iso, const std::vector<Color>& colors) {
  options.iso = iso;
  surface->set_options(options);
  SceneObject& object = scene.objects.front();
  object.colors.clear();
  for (std::size_t i = 0; i < iso.size(); ++i)
    object.colors.push_back(colors.empty() ? default_color(i) : colors[i % colors.size()]);
}

BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings) {
  BuiltScene built;
  const VolumeDescription& wanted = description.volume;
  built.options.method = choose_cell_method(wanted.method, wanted.settings);
  built.options.double_precision = settings.double_precision;
  built.options.isa = settings.isa;
  built.options.normals = wanted.normals;
  built.method = std::string(volume_methods()[static_cast<std::size_t>(built.options.method.method)].name);
  if (wanted.method == "auto")
    built.method_reason = "the first root of the exact cubic, isolated: right and fastest of those that are";

  auto start = std::chrono::steady_clock::now();
  built.volume = std::make_shared<const Volume>(read_volume(wanted.file, wanted.read));
  const std::vector<double> iso = wanted.iso.empty() ? best_iso(*built.volume, wanted.file) : wanted.iso;
  built.load_ms = ms_since(start);

  start = std::chrono::steady_clock::now();
  built.options.iso = iso;
  built.surface = std::make_shared<VolumeSurface>(built.volume, built.options);
  built.scene.objects.push_back({built.surface, {}});
  built.set_iso(iso, wanted.colors);
  built.scene.light = description.light;
  built.scene.shadows = description.shadows;
  built.build_ms = ms_since(start);

  built.features = {"volume", fmt::format("iso:{}", iso.size()),
                    fmt::format("format:{}", built.volume->format)};
  const auto list = [&](bool used, const char* name) {
    (used ? built.features : built.left_out).push_back(name);
  };
  list(built.volume->tree != nullptr, "sparse tree");
  list(built.volume->tree == nullptr, "macrocells");
  list(built.volume->mapped, "memory mapping");
  list(!built.volume->mapped, "copy of the samples");
  list(wanted.iso.empty(), "statistics");
  list(built.volume->format == "nifti", "module:nifti");
  list(built.volume->format == "vdb", "process:openvdb");
  return built;
}

}  // namespace isocast
