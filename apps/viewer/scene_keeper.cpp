#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/no_surface.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/apps/viewer/scene_document.h>
#include <isocast/apps/viewer/scene_keeper.h>
#include <isocast/base/error.h>
#include <isocast/render/environment_file.h>

#include <utility>

namespace isocast::viewer {
namespace {

bool is_volume(const RenderWords& words) {
  return !is_scene_file(words.input) &&
         is_volume_file(words.input, parse_parameters(words.params, "--param"));
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
  list.push_back(fmt::format("{}", more.size()));
  list.insert(list.end(), more.begin(), more.end());
}

// What decides how rays are traced, beside the scene.
std::vector<std::string> method_words(const RenderWords& words) {
  std::vector<std::string> list = {words.method, words.precision, words.isa};
  append(list, words.set);
  return list;
}

ObjectNews news_of(const BuiltObject& built, const Scene& scene, const ObjectDescription& description) {
  ObjectNews news{built.volume != nullptr, built.iso, {}, built.method, built.method_reason, {}};
  for (std::size_t part = 0; part < built.count; ++part) {
    const std::vector<Material>& materials = scene.objects[built.place + part].materials;
    news.materials.insert(news.materials.end(), materials.begin(), materials.end());
  }
  if (!built.move_surface && !news.materials.empty()) news.iso = {0}, news.materials.resize(1);
  if (built.change_method)
    for (const Method& method : applicable_methods(description)) news.methods.emplace_back(method.name);
  return news;
}

}  // namespace

std::vector<std::string> source_of(const RenderWords& words) {
  std::vector<std::string> source = {words.input,   words.domain,    words.time,
                                     words.normals, words.read.grid, words.by_component ? "components" : ""};
  if (!words.scene_text.empty()) source.push_back(built_part(words.scene_text));
  append(source, words.params);
  if (!is_volume(words)) append(source, method_words(words));
  return source;
}

void SceneKeeper::show(const RenderWords& words) {
  const std::vector<std::string> source = source_of(words);
  std::vector<std::string> tried = source;
  tried.push_back(words.frames);
  if (tried == failed_) throw InputError(failure_);
  try {
    SceneDescription description = describe(words);
    if (!words.iso.empty()) description.objects.front().iso = parse_numbers(words.iso, "--iso");
    const bool stays = words.frames == words_.frames || !rebuilt_by_frames(describe_all(words));
    if (built_ && source == source_ && stays) change(words, description);
    else build(words, description);
    description_ = std::move(description);
    words_ = words;
    source_ = source;
    prepare_previews();
    failed_.clear();
  } catch (const Interrupted&) {
    failed_ = std::move(tried);
    failure_ = "loading was cancelled";
    throw;
  }
}

void SceneKeeper::build(const RenderWords& words, const SceneDescription& description) {
  BuiltScene built = build_scene(description, evaluation_of(words), library_);
  library_.drop_unused();
  built_ = std::move(built);
  moved_.clear();
  walker_.reset();
  ++scene_;
}

void SceneKeeper::change(const RenderWords& words, const SceneDescription& description) {
  const bool evaluated_otherwise = words.precision != words_.precision || words.isa != words_.isa;
  for (std::size_t k = 0; k < description.objects.size(); ++k) {
    change(k, description.objects[k], evaluated_otherwise, evaluation_of(words));
    const std::vector<SolidDescription> clips = description.clips_of(k);
    if (!clips.empty() || !description_.clips_of(k).empty()) built_->set_clips(k, clips);
  }
  built_->scene.lights = description.lights;
  built_->scene.shadows = description.shadows;
  built_->scene.ambient_occlusion = description.ambient_occlusion;
  if (words.environment != words_.environment)
    built_->scene.environment = words.environment.empty() ? nullptr : read_environment(words.environment);
}

void SceneKeeper::change(std::size_t k, const ObjectDescription& wanted, bool evaluated_otherwise,
                         const EvaluationSettings& evaluation) {
  const ObjectDescription& before = description_.objects[k];
  BuiltObject& built = built_->objects[k];
  const bool other_method = wanted.method != before.method || wanted.settings != before.settings;
  if (built.volume && (other_method || evaluated_otherwise)) {
    const std::string method = wanted.method == "auto" ? "marmitt" : wanted.method;
    built.change_method(method, wanted.settings, evaluation);
    built.method = method;
    built.method_reason.clear();
    built.proves = built.unclipped.front()->proves();
  }
  if (built.move_surface && (wanted.iso != before.iso || wanted.materials != before.materials)) {
    built_->set_iso(k, wanted.iso.empty() ? default_iso(wanted) : wanted.iso, wanted.materials);
    if (wanted.iso != before.iso) moved_.insert(k);
  }
}

bool SceneKeeper::choose_methods() {
  bool other = false;
  for (const std::size_t k : moved_) other = built_->choose_method(k) || other;
  moved_.clear();
  return other;
}

std::vector<double> SceneKeeper::default_iso(const ObjectDescription& object) {
  const auto* const volume = std::get_if<VolumeSource>(&object.source);
  if (!volume) return {0};
  return {library_.statistics(*volume)->suggested_iso.front()};
}

std::shared_ptr<const VolumeStatistics> SceneKeeper::statistics(std::size_t object) {
  const ObjectDescription& description = description_.objects[object];
  const auto* const volume = std::get_if<VolumeSource>(&description.source);
  return volume && description.visible ? library_.statistics(*volume) : nullptr;
}

void SceneKeeper::prepare_previews() {
  preview_ = built_->scene;
  const ObjectDescription& object = description_.objects.front();
  const BuiltObject& built = built_->objects.front();
  if (built_->scene.objects.size() > 1 || !built.volume || !description_.clips_of(0).empty()) return;
  const EvaluationSettings evaluation = evaluation_of(words_);
  VolumeSurfaceOptions options;
  options.iso = built.iso;
  options.method = choose_cell_method(object.method, object.settings);
  options.double_precision = evaluation.double_precision;
  options.isa = evaluation.isa;
  options.normals = object.normals;
  options.order = RayOrder::walk;
  if (walker_) walker_->set_options(options);
  else walker_ = std::make_shared<VolumeSurface>(built.volume, options);
  preview_.objects.front().surface = walker_;
}

MethodRestorer::~MethodRestorer() {
  const BuiltObject& object = keeper_.built().objects[object_];
  object.change_method(object.method, keeper_.description().objects[object_].settings,
                       evaluation_of(keeper_.words()));
}

bool SceneKeeper::has_methods(std::size_t object) const {
  return built_ && object < built_->objects.size() && description_.objects[object].visible &&
         built_->objects[object].change_method;
}

LoneObject SceneKeeper::alone(std::size_t object) const {
  LoneObject lone{description_, *built_};
  ObjectDescription& described = lone.description.objects[object];
  described.clips.clear();
  described.color_by.reset();
  const BuiltObject& built = built_->objects[object];
  for (SceneObject& other : lone.built.scene.objects) other.surface = std::make_shared<NoSurface>();
  for (std::size_t part = 0; part < built.count; ++part)
    lone.built.scene.objects[built.place + part].surface = built.unclipped[part];
  lone.description.objects = {std::move(described)};
  lone.built.objects = {built};
  return lone;
}

SceneNews SceneKeeper::news() const {
  SceneNews news;
  news.any = any();
  if (!any()) return news;
  news.proves = built_->proves();
  news.bounds = built_->scene.bounds();
  news.camera = description_.camera;
  for (std::size_t k = 0; k < built_->objects.size(); ++k)
    news.objects.push_back(news_of(built_->objects[k], built_->scene, description_.objects[k]));
  news.isa = isa_word(evaluation_of(words_));
  const auto& volume = built_->objects.front().volume;
  if (volume) news.type = std::string(volume->type_name());
  news.features = built_->features;
  news.left_out = built_->left_out;
  news.volume_bytes = built_->volume_bytes;
  news.acceleration_bytes = built_->acceleration_bytes;
  news.load_ms = built_->load_ms;
  news.build_ms = built_->build_ms;
  news.scene = scene_;
  return news;
}

}  // namespace isocast::viewer
