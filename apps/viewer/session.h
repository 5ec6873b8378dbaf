// What the user of the viewer wants to see: plain data, no window.
#pragma once

#include <isocast/apps/isocast/render_words.h>

#include <optional>
#include <string>
#include <vector>

namespace isocast::viewer {

/// One iso-value in the file's scaled units with its look; `visible` is its eye.
struct IsoSurface {
  double value = 0;
  Color color = {1, 1, 1};  // linear
  double opacity = 1, reflectivity = 0;
  bool visible = true;
  bool operator==(const IsoSurface&) const = default;
};

/// The input and options as the command line has them, and what changes most under the mouse.
///
/// surfaces  empty: the input's own default iso-value, which nobody knows before it is loaded
/// adopted   that default: as long as the surfaces are still these, the words say nothing of them
/// camera    none: the one of `words`, which frames the scene where they leave it open
struct Session {
  RenderWords words;
  std::vector<IsoSurface> surfaces, adopted;
  std::optional<Camera> camera;
};

/// The session that a command line starts. Throws InputError for iso-values, colours and shares that cannot
/// be used.
[[nodiscard]] Session start_session(const RenderWords& words);

/// Iso-values that an input has by itself, and their looks.
void adopt_surfaces(Session& session, const std::vector<double>& values,
                    const std::vector<Material>& materials);

/// One more iso-value, in the next colour of the palette.
void add_surface(Session& session, double value);

/// The command line of `isocast render` that makes this picture: hidden surfaces are not in it.
[[nodiscard]] RenderWords words_of(const Session& session, int width, int height);

/// "#rrggbb" of a linear colour.
[[nodiscard]] std::string hex_of(const Color& color);

}  // namespace isocast::viewer
