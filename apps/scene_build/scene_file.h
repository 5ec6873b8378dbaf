// Scene files.
#pragma once

#include <isocast/apps/scene_build/description.h>

#include <filesystem>
#include <string>

namespace isocast {

/// Whether a word names a scene file: it ends with .json.
[[nodiscard]] bool is_scene_file(const std::string& word);

/// Reads a scene (interface.md, "Scene files"; docs/scenes.md has every key). Nothing that it names is opened
/// but .vm tapes. Throws InputError with the path of the key that cannot be used.
[[nodiscard]] SceneDescription read_scene(const std::filesystem::path& path);

/// The same from text; files are relative to `folder`, and `source` names the text in messages.
[[nodiscard]] SceneDescription scene_from_text(const std::string& text, const std::string& source,
                                               const std::filesystem::path& folder);

/// The camera of that name becomes the one in use. Throws InputError with the names that there are.
void use_camera(SceneDescription& scene, const std::string& name);

}  // namespace isocast
