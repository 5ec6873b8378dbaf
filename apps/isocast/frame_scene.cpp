#include <isocast/apps/isocast/frame_scene.h>
#include <isocast/base/mapped_file.h>

#include <algorithm>

namespace isocast {
namespace {

bool is_numbered(const std::filesystem::path& file) {
  return file.filename().string().find('%') != std::string::npos;
}

// Whether any of its files has the frame's number in its name.
bool follows_frames(const ObjectDescription& object) {
  if (const auto* const csg = std::get_if<CsgSource>(&object.source))
    return std::ranges::any_of(csg->of, follows_frames);
  if (const auto* const volume = std::get_if<VolumeSource>(&object.source);
      volume && is_numbered(volume->file))
    return true;
  if (const auto* const mesh = std::get_if<MeshSource>(&object.source); mesh && is_numbered(mesh->file))
    return true;
  const auto* const field = object.color_by ? std::get_if<VolumeSource>(&object.color_by->field) : nullptr;
  return field && is_numbered(field->file);
}

// Whether other iso-values only move its surfaces.
bool moves(const SceneDescription& scene, const std::string& name) {
  return std::ranges::any_of(scene.objects, [&](const ObjectDescription& object) {
    return object.name == name && (std::holds_alternative<VolumeSource>(object.source) ||
                                   std::holds_alternative<FormulaSource>(object.source));
  });
}

}  // namespace

FrameScene::FrameScene(const RenderWords& words, SceneDescription all, const EvaluationSettings& evaluation)
    : words_(words), all_(std::move(all)), evaluation_(evaluation), described_by_(take_files_read()) {}

bool FrameScene::is_rebuilt(const FrameJob& job) const {
  if (!built_ || job.time || std::ranges::any_of(all_.objects, follows_frames)) return true;
  return all_.animation && std::ranges::any_of(all_.animation->keys, [&](const AnimationKey& key) {
           return key.time || !key.parameters.empty() ||
                  !std::ranges::all_of(key.iso, [&](const auto& iso) { return moves(all_, iso.first); });
         });
}

void FrameScene::go_to(const FrameJob& job) {
  SceneDescription next = describe_frame(words_, all_, job);
  if (is_rebuilt(job)) {
    built_.reset();
    (void)take_files_read();
    built_ = build_scene(next, evaluation_);
    built_from_ = take_files_read();
  } else
    for (std::size_t i = 0; i < next.objects.size(); ++i)
      if (!next.objects[i].iso.empty() && next.objects[i].iso != description_.objects[i].iso) {
        built_->set_iso(i, next.objects[i].iso, next.objects[i].materials);
        built_->choose_method(i);
      }
  description_ = std::move(next);
}

std::vector<std::filesystem::path> FrameScene::inputs() const {
  std::vector<std::filesystem::path> inputs = described_by_;
  for (const std::filesystem::path& file : built_from_)
    if (std::ranges::find(inputs, file) == inputs.end()) inputs.push_back(file);
  return inputs;
}

}  // namespace isocast
