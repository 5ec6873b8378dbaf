// From a description to surfaces: the only place that knows every kind of surface.
#pragma once

#include <isocast/apps/scene_build/description.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace isocast {

/// How the scene is evaluated, the same for all its objects.
struct EvaluationSettings {
  Isa isa = widest_isa();
  bool double_precision = false, mixed_precision = false;
};

/// A scene with what was learnt while it was built, for --stats.
struct BuiltScene {
  Scene scene;
  std::string method, method_reason;  // method_reason only when the method was "auto"
  std::vector<std::string> features, left_out;
  std::vector<double> iso;
  double load_ms = 0, build_ms = 0;
  std::int64_t volume_bytes = 0, acceleration_bytes = 0;
  bool proves = false;
  std::shared_ptr<const Volume> volume;  // of a volume
  std::size_t components = 0;            // of a formula, where they have materials of their own
  std::function<void(const std::vector<double>& iso)> move_surface;
  /// Goes on with another method (by name, not auto), its `--set` values and another evaluation; nothing is
  /// rebuilt, and `method` and `proves` stay what they were. Throws InputError for what cannot be used.
  std::function<void(const std::string& method, const std::map<std::string, std::string>& settings,
                     const EvaluationSettings& evaluation)>
      change_method;

  /// Moves the surfaces to other iso-values (the file's scaled units); nothing is rebuilt.
  void set_iso(const std::vector<double>& iso, const MaterialDescription& materials);
};

/// Opens and builds what the description names and nothing else. Throws InputError for files, methods and
/// options that cannot be used.
[[nodiscard]] BuiltScene build_scene(const SceneDescription& description, const EvaluationSettings& settings);

}  // namespace isocast
