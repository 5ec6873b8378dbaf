// From the description of one object to its surface: the only place that knows every kind of surface.
#pragma once

#include <isocast/apps/scene_build/compute_device.h>
#include <isocast/apps/scene_build/description.h>
#include <isocast/apps/scene_build/volume_library.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isocast {

/// An object with what was learnt while it was built.
///
/// place     number of its first SceneObject in the scene, `count` how many it has: an instance one for each
/// of
///           its places, iso-values one for every sixteen
/// features  what of it is used, and what was left out
/// unclipped  its surfaces before clip solids, one for each SceneObject
/// move_surface, change_method  for a volume or a formula; else empty
struct BuiltObject {
  std::string name;
  std::size_t place = 0, count = 1;
  std::string method, method_reason;  // method_reason only when the method was "auto"
  std::vector<double> iso;
  bool proves = false;
  std::shared_ptr<const Volume> volume;  // of a volume
  std::size_t components = 0;            // of a formula, where they have materials of their own
  std::vector<std::shared_ptr<const Surface>> unclipped;
  std::function<void(const std::vector<double>& iso)> move_surface;
  /// Chooses the method anew for the iso-values to which the surface has been moved, and returns its name;
  /// empty where that changes nothing.
  std::function<std::string()> choose_method;
  /// Goes on with another method (by name, not auto), its `--set` values and another evaluation; nothing is
  /// rebuilt, and `method` and `proves` stay what they were. Throws InputError for what cannot be used.
  std::function<void(const std::string& method, const std::map<std::string, std::string>& settings,
                     const EvaluationSettings& evaluation)>
      change_method;
  std::function<MaskUse()> mask_use;  // of a volume
  std::vector<std::string> features, left_out;
  double load_ms = 0, build_ms = 0;
  std::int64_t volume_bytes = 0, acceleration_bytes = 0;
};

/// What building needs besides a description.
///
/// number   of the surface in its scene, what hits will say
/// library  volumes that were read already
struct BuildContext {
  const EvaluationSettings& settings;
  std::uint16_t number;
  VolumeLibrary& library;
};

/// An object with its surface, and a material for each of its iso-values or components.
///
/// solid  the box at which it ends, and which closes it as a solid; none: it is closed
/// above  as a solid it is where f >= iso
struct ObjectSurface {
  struct Solid {
    Box box;
    Transform world_from_box;
  };
  BuiltObject built;
  std::shared_ptr<const Surface> surface;
  std::vector<Material> materials;
  std::optional<Solid> solid;
  bool above = false;
};

/// The object of a description, but for instances. Throws InputError.
[[nodiscard]] ObjectSurface build_object(const ObjectDescription& description, const BuildContext& context);

/// What of the surfaces, whose numbers begin with `place`, lies in all solids.
[[nodiscard]] std::vector<std::shared_ptr<const Surface>> clipped(
    const std::vector<std::shared_ptr<const Surface>>& surfaces, const std::vector<SolidDescription>& solids,
    std::size_t place);

/// Materials in number, as the description repeats them.
[[nodiscard]] std::vector<Material> materials_of(const MaterialDescription& description, std::size_t count);

}  // namespace isocast
