#include <isocast/apps/isocast/frame_scene.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/base/mapped_file.h>

#include <algorithm>

namespace isocast {
FrameScene::FrameScene(const RenderWords& words, SceneDescription all, const EvaluationSettings& evaluation)
    : words_(words), all_(std::move(all)), evaluation_(evaluation), described_by_(take_files_read()) {}

bool FrameScene::is_rebuilt(const FrameJob& job) const {
  return !built_ || job.time || rebuilt_by_frames(all_);
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
