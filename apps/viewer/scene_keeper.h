// The scene behind the pictures: a new wish changes as little of it as possible.
#pragma once

#include <isocast/apps/viewer/wish.h>

#include <optional>
#include <set>

namespace isocast::viewer {

/// An object as if it were the only one, and without its clip solids and colours, of which references know
/// nothing.
struct LoneObject {
  SceneDescription description;
  BuiltScene built;
};

/// Of the render thread.
class SceneKeeper {
 public:
  /// Makes the scene that of these words. Another input is loaded and built; of a volume another method,
  /// iso-values, looks, clip solids and lights rebuild nothing, of a formula all of these but the method, and
  /// volumes that stay are not loaded again. Throws
  /// InputError, and Interrupted where the work is unwanted: then the scene is what it was, and the same
  /// source is not tried again.
  void show(const RenderWords& words);

  [[nodiscard]] bool any() const { return built_.has_value(); }
  [[nodiscard]] BuiltScene& built() { return *built_; }
  /// The same scene for previews: the rays of a volume walk, for which nothing is made at a new iso-value.
  [[nodiscard]] const Scene& preview_scene() const { return preview_; }
  [[nodiscard]] const SceneDescription& description() const { return description_; }
  [[nodiscard]] const RenderWords& words() const { return words_; }
  /// Whether other methods can be tried at an object: a volume or a formula that is there.
  [[nodiscard]] bool has_methods(std::size_t object) const;
  /// Its surfaces are the scene's: a method that is tried at it is changed in both.
  [[nodiscard]] LoneObject alone(std::size_t object) const;
  /// How many scenes there have been.
  [[nodiscard]] int scene() const { return scene_; }
  /// Chooses methods anew where surfaces were moved, so that the scene is as if it were built now; returns
  /// whether one is another than before.
  bool choose_methods();
  /// Of an object's volume; null: it has none.
  [[nodiscard]] std::shared_ptr<const VolumeStatistics> statistics(std::size_t object);
  /// What the interface needs to know of it.
  [[nodiscard]] SceneNews news() const;

 private:
  void build(const RenderWords& words, const SceneDescription& description);
  void change(const RenderWords& words, const SceneDescription& description);
  void change(std::size_t k, const ObjectDescription& wanted, bool evaluated_otherwise,
              const EvaluationSettings& evaluation);
  [[nodiscard]] std::vector<double> default_iso(const ObjectDescription& object);
  void prepare_previews();

  VolumeLibrary library_;
  std::optional<BuiltScene> built_;
  Scene preview_;
  std::shared_ptr<VolumeSurface> walker_;  // of previews; null where they have the scene's own surfaces
  SceneDescription description_;
  RenderWords words_;
  std::vector<std::string> source_, failed_;  // failed_: with the frame
  std::string failure_;
  int scene_ = 0;
  std::set<std::size_t> moved_;  // objects whose methods were not chosen since
};

/// Puts an object's method back when it goes: others may be tried meanwhile.
class MethodRestorer {
 public:
  MethodRestorer(SceneKeeper& keeper, std::size_t object) : keeper_(keeper), object_(object) {}
  ~MethodRestorer();
  MethodRestorer(const MethodRestorer&) = delete;
  MethodRestorer& operator=(const MethodRestorer&) = delete;

 private:
  SceneKeeper& keeper_;
  std::size_t object_;
};

/// Everything of the words that makes it another scene, which must be loaded or built.
[[nodiscard]] std::vector<std::string> source_of(const RenderWords& words);

}  // namespace isocast::viewer
