#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/scene_file.h>
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

}  // namespace

std::vector<std::string> source_of(const RenderWords& words) {
  std::vector<std::string> source = {words.input,   words.domain,    words.time,
                                     words.normals, words.read.grid, words.by_component ? "components" : ""};
  append(source, words.params);
  append(source, words.clips);
  if (!is_volume(words)) append(source, method_words(words));
  return source;
}

void SceneKeeper::show(const RenderWords& words) {
  const std::vector<std::string> source = source_of(words);
  if (source == failed_) throw InputError(failure_);
  try {
    SceneDescription description = describe(words);
    if (!words.iso.empty()) description.objects.front().iso = parse_numbers(words.iso, "--iso");
    if (built_ && source == source_) change(words, description);
    else build(words, description);
    description_ = std::move(description);
    words_ = words;
    source_ = source;
    prepare_previews();
    failed_.clear();
  } catch (const Interrupted&) {
    failed_ = source;
    failure_ = "loading was cancelled";
    throw;
  }
}

void SceneKeeper::build(const RenderWords& words, const SceneDescription& description) {
  BuiltScene built = build_scene(description, evaluation_of(words));
  built_ = std::move(built);
  walker_.reset();
  ++scene_;
}

void SceneKeeper::change(const RenderWords& words, const SceneDescription& description) {
  const ObjectDescription& object = description.objects.front();
  BuiltObject& first = built_->objects.front();
  if (method_words(words) != method_words(words_)) {
    const std::string method = object.method == "auto" ? "marmitt" : object.method;
    first.change_method(method, object.settings, evaluation_of(words));
    first.method = method;
    first.method_reason.clear();
    first.proves = built_->scene.objects.front().surface->proves();
  }
  if (first.move_surface) built_->set_iso(0, object.iso.empty() ? first.iso : object.iso, object.materials);
  built_->scene.lights = description.lights;
  built_->scene.shadows = description.shadows;
  built_->scene.ambient_occlusion = description.ambient_occlusion;
  if (words.environment != words_.environment)
    built_->scene.environment = words.environment.empty() ? nullptr : read_environment(words.environment);
}

void SceneKeeper::prepare_previews() {
  preview_ = built_->scene;
  const ObjectDescription& object = description_.objects.front();
  if (!is_volume(words_) || !object.clips.empty()) return;
  const EvaluationSettings evaluation = evaluation_of(words_);
  VolumeSurfaceOptions options;
  options.iso = built_->objects.front().iso;
  options.method = choose_cell_method(object.method, object.settings);
  options.double_precision = evaluation.double_precision;
  options.isa = evaluation.isa;
  options.normals = object.normals;
  options.order = RayOrder::walk;
  if (walker_) walker_->set_options(options);
  else walker_ = std::make_shared<VolumeSurface>(built_->objects.front().volume, options);
  preview_.objects.front().surface = walker_;
}

MethodRestorer::~MethodRestorer() {
  const BuiltObject& object = keeper_.built().objects.front();
  if (object.change_method)
    object.change_method(object.method, keeper_.description().objects.front().settings,
                         evaluation_of(keeper_.words()));
}

SceneNews SceneKeeper::news() const {
  SceneNews news;
  news.any = any();
  if (!any()) return news;
  const BuiltObject& first = built_->objects.front();
  news.is_volume = first.volume != nullptr;
  news.proves = built_->proves();
  news.bounds = built_->scene.bounds();
  news.camera = description_.camera;
  news.iso = first.iso;
  news.materials = built_->scene.objects.front().materials;
  news.objects = built_->objects.size();
  news.method = first.method;
  news.method_reason = first.method_reason;
  news.isa = isa_word(evaluation_of(words_));
  if (first.volume) news.type = std::string(first.volume->type_name());
  if (first.change_method)
    for (const Method& method : applicable_methods(description_.objects.front()))
      news.methods.emplace_back(method.name);
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
