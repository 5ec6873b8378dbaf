// What the user of the viewer wants to see: plain data, no window.
#pragma once

#include <isocast/apps/isocast/render_words.h>
#include <isocast/apps/viewer/scene_document.h>

#include <optional>
#include <string>
#include <vector>

namespace isocast::viewer {

/// The input and options as the command line has them, and what changes most under the mouse.
///
/// document  the scene of a scene file; without one the input is the only object
/// objects   as the user wants them; at least one
/// current   the object that the panels show
/// numbers   the first and the last of volumes whose name takes the frame's number
/// frame     of an animation or of numbered volumes; none: its first
/// camera    none: the one of `words`, which frames the scene where they leave it open
struct Session {
  RenderWords words;
  std::optional<SceneJson> document;
  std::vector<SessionObject> objects = std::vector<SessionObject>(1);
  std::size_t current = 0;
  std::optional<std::array<int, 2>> numbers;
  std::optional<int> frame;
  std::optional<Camera> camera;

  [[nodiscard]] SessionObject& object() { return objects[current]; }
  [[nodiscard]] const SessionObject& object() const { return objects[current]; }
  /// The first and the last frame of the scene's animation or of its numbered volumes, if it has any.
  [[nodiscard]] std::optional<std::array<int, 2>> frames() const;
};

/// The session that a command line starts. Throws InputError for scene files, iso-values, colours and shares
/// that cannot be used.
[[nodiscard]] Session start_session(const RenderWords& words);

/// Iso-values that an object has by itself, and their looks.
void adopt_surfaces(SessionObject& object, const std::vector<double>& values,
                    const std::vector<Material>& materials);

/// One more iso-value, in the next colour of the palette.
void add_surface(SessionObject& object, double value);

/// The words of `isocast render` that make this picture: hidden surfaces are not in it. clips: formulas of
/// clip planes. What words cannot say is in RenderWords::scene_text.
[[nodiscard]] RenderWords words_of(const Session& session, int width, int height,
                                   const std::vector<std::string>& clips = {});

/// The same words with what scene_text says in a file, so that they can be typed: the session's own where
/// nothing of it was changed, else OUTPUT.scene.json, which is written. Throws InputError.
[[nodiscard]] RenderWords write_scene(const Session& session, RenderWords words, const std::string& output);

/// "#rrggbb" of a linear colour.
[[nodiscard]] std::string hex_of(const Color& color);

}  // namespace isocast::viewer
