// The whole catalogue as one picture.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>

#include <map>
#include <string>
#include <vector>

namespace isocast {

/// How the surfaces of a sheet are drawn.
///
/// size      pixels along both edges of a tile
/// method    by name, or auto for each surface's own choice; `settings` are its options
/// time      of surfaces that move
struct SheetWishes {
  int size = 256;
  std::string method = "auto";
  std::map<std::string, std::string> settings;
  double time = 0;
  EvaluationSettings evaluation;
};

/// Linear RGBA, rows from the top.
struct Sheet {
  int width, height;
  std::vector<float> rgba;
};

/// Every surface of the catalogue in a tile of its own, as `render @id` draws it, row by row in the table's
/// order, with its id along the lower edge. There are as many columns as rows, or one more. Throws InputError
/// for methods and settings that cannot be used, and Interrupted after Ctrl-C.
[[nodiscard]] Sheet draw_catalogue(const SheetWishes& wishes);

}  // namespace isocast
