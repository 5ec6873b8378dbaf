// The scene of one frame after the other.
#pragma once

#include <isocast/apps/isocast/manifest.h>
#include <isocast/apps/isocast/render_words.h>
#include <isocast/apps/scene_build/scene_build.h>

#include <optional>

namespace isocast {

/// Builds what a frame needs, and only what changes from the one before: other cameras build nothing, other
/// iso-values of volumes and formulas move surfaces.
class FrameScene {
 public:
  /// all: of all frames (describe_all); words must live as long
  FrameScene(const RenderWords& words, SceneDescription all, const EvaluationSettings& evaluation);

  [[nodiscard]] const SceneDescription& all() const { return all_; }
  /// Makes the scene that of a frame. Throws InputError for what cannot be built.
  void go_to(const FrameJob& job);
  /// Of the frame, once there is one.
  [[nodiscard]] const BuiltScene& built() const { return *built_; }
  [[nodiscard]] const SceneDescription& description() const { return description_; }
  /// The files that were read for it; scene files, tapes and maps among them.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;

 private:
  [[nodiscard]] bool is_rebuilt(const FrameJob& job) const;

  const RenderWords& words_;
  SceneDescription all_, description_;
  EvaluationSettings evaluation_;
  std::vector<std::filesystem::path> described_by_, built_from_;
  std::optional<BuiltScene> built_;
};

}  // namespace isocast
