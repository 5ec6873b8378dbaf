// From the description of one object to its surface: the only place that knows every kind of surface.
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

/// An object with what was learnt while it was built.
///
/// place       number of its SceneObject in the scene
/// features    what of it is used, and what was left out
struct BuiltObject {
  std::string name;
  std::size_t place = 0;
  std::string method, method_reason;  // method_reason only when the method was "auto"
  std::vector<double> iso;
  bool proves = false;
  std::shared_ptr<const Volume> volume;  // of a volume
  std::size_t components = 0;            // of a formula, where they have materials of their own
  std::function<void(const std::vector<double>& iso)> move_surface;
  /// Goes on with another method (by name, not auto), its `--set` values and another evaluation; nothing is
  /// rebuilt, and `method` and `proves` stay what they were. Throws InputError for what cannot be used.
  std::function<void(const std::string& method, const std::map<std::string, std::string>& settings,
                     const EvaluationSettings& evaluation)>
      change_method;
  std::vector<std::string> features, left_out;
  double load_ms = 0, build_ms = 0;
  std::int64_t volume_bytes = 0, acceleration_bytes = 0;
};

/// The object of a description with its surface.
///
/// number  of the surface in its scene, what hits will say
struct ObjectSurface {
  BuiltObject built;
  std::shared_ptr<const Surface> surface;
};
[[nodiscard]] ObjectSurface build_object(const ObjectDescription& description,
                                         const EvaluationSettings& settings, std::uint16_t number);

}  // namespace isocast
