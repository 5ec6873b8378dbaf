// Objects of a scene file, from JSON that follows the rules.
#pragma once

#include <isocast/apps/scene_build/description.h>
#include <isocast/apps/scene_build/scene_json.h>

namespace isocast {

/// source  the scene's name, for messages
/// folder  what its relative files are relative to
/// time    the scene's
struct SceneContext {
  std::string source;
  std::filesystem::path folder;
  double time;
};

/// path: of the value in the file. Throws InputError for formulas, names and combinations that cannot be
/// used.
[[nodiscard]] ObjectDescription object_from_json(const SceneJson& value, const std::string& path,
                                                 const SceneContext& context);

/// A list of clip solids; null: none. path, errors: as above.
[[nodiscard]] std::vector<SolidDescription> clips_from_json(const SceneJson& value, const std::string& path,
                                                            const SceneContext& context);

[[nodiscard]] Color color_from_json(const SceneJson& value);
[[nodiscard]] Double3 point_from_json(const SceneJson& value);

}  // namespace isocast
