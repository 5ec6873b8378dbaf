// From a description to surfaces.
#pragma once

#include <isocast/apps/scene_build/build_object.h>

#include <string>
#include <vector>

namespace isocast {

/// A scene with what was learnt while it was built, for --stats. objects: those of the description, in its
/// order.
struct BuiltScene {
  Scene scene;
  std::vector<BuiltObject> objects;
  std::vector<std::string> features, left_out;
  double load_ms = 0, build_ms = 0;
  std::int64_t volume_bytes = 0, acceleration_bytes = 0;

  /// Moves an object's surfaces to other iso-values (the file's scaled units); nothing is rebuilt.
  void set_iso(std::size_t object, const std::vector<double>& iso, const MaterialDescription& materials);
  /// Chooses an object's method as if the scene were built with the iso-values that it has now; returns
  /// whether it is another one. Without this a moved surface keeps its method.
  bool choose_method(std::size_t object);
  /// Other clip solids of an object, all that cut it (SceneDescription::clips_of); nothing is rebuilt.
  void set_clips(std::size_t object, const std::vector<SolidDescription>& clips);
  /// Whether any object's hits and misses come with proofs.
  [[nodiscard]] bool proves() const;
};

/// Opens and builds what the description names and nothing else; volumes that the library has are not read
/// again. Throws InputError for files, methods and options that cannot be used.
[[nodiscard]] BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings,
                                     VolumeLibrary& library);
[[nodiscard]] BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings);

}  // namespace isocast
