// What the user of the viewer may change of one object.
#pragma once

#include <isocast/scene/material.h>

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

/// Colours by another field, as they are typed.
///
/// of     a formula or a volume's file; empty: none
/// map    a name or a ParaView .json
/// range  "LO,HI"; empty: the field's own
struct ColorWords {
  std::string of, map = "viridis", range;
  bool logarithmic = false;
  bool operator==(const ColorWords&) const = default;
};

/// type      as in a scene file
/// surfaces  empty: the object's own default iso-value, which nobody knows before it is loaded; of a mesh, a
///           csg or instances the look of the whole
/// adopted   that default: as long as the surfaces are still these, nobody speaks of them
struct SessionObject {
  std::string name, type, method = "auto";
  std::vector<std::string> set;
  bool visible = true;
  ColorWords color_by;
  std::vector<IsoSurface> surfaces, adopted;

  [[nodiscard]] bool is_formula() const { return type == "formula" || type == "surface"; }
  [[nodiscard]] bool has_iso() const { return type == "volume" || is_formula(); }
};

}  // namespace isocast::viewer
