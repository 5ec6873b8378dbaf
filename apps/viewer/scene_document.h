// The scene file that the viewer edits, shows and writes.
#pragma once

#include <isocast/apps/isocast/render_words.h>
#include <isocast/apps/scene_build/scene_json.h>
#include <isocast/apps/viewer/session_object.h>

#include <string>
#include <vector>

namespace isocast::viewer {

/// The scene of the words as a file would have it: of a scene file what it holds, with what the words change
/// of its only object; else the input as the only object. All files have their full names. Throws InputError.
[[nodiscard]] SceneJson document_of(const RenderWords& words);

/// Takes out of the words what document_of has put into the scene.
void clear_object_words(RenderWords& words);

/// What can be edited of an object, without its surfaces.
[[nodiscard]] SessionObject read_object(const SceneJson& object);

/// Writes what of it differs from the object.
void write_object(const SessionObject& from, SceneJson& object);

/// Iso-values of the object of that name stay as they are from now on.
void stop_animated_iso(const std::string& name, SceneJson& document);

/// On one line, or over several for people.
[[nodiscard]] std::string text_of(const SceneJson& document, bool for_people = false);

/// The text without what changes in a scene that is built: iso-values, looks and the scene's clip solids, and
/// of volumes the method; and without its animation.
[[nodiscard]] std::string built_part(const std::string& scene_text);

}  // namespace isocast::viewer
