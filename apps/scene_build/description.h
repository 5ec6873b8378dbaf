// What the user asked for, as plain data: nothing is loaded yet.
#pragma once

#include <isocast/implicit/implicit_surface.h>
#include <isocast/render/camera.h>
#include <isocast/scene/scene.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/volume_surface.h>

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace isocast {

struct VolumeSource {
  std::filesystem::path file;
  ReadOptions read;
};
struct FormulaSource {
  Expression expression;
  Domain domain;
  double time = 0;
};

/// Each list is repeated over the iso-values. Empty: the default palette, opaque, without reflections.
struct MaterialDescription {
  std::vector<Color> colors;
  std::vector<double> opacities, reflectivities;
};

/// The points where the formula is not positive at this time.
struct SolidDescription {
  Expression formula;
  double time = 0;
};

/// Iso-surfaces of a volume (`iso` in the file's scaled units; empty: the best of suggested_iso) or of a
/// formula in a box (empty: 0). `by_component`: the materials are those of the operands of
/// the min and max in which the formula ends. `clips`: only what lies in all of them is there.
struct ObjectDescription {
  std::variant<VolumeSource, FormulaSource> source;
  std::vector<double> iso;
  MaterialDescription materials;
  std::string method = "auto";
  std::map<std::string, std::string> settings;
  NormalKind normals = NormalKind::gradient;
  bool by_component = false;
  std::vector<SolidDescription> clips;
};

/// A scene of one object, its lights and environment (a picture of all directions; empty: none), and what is
/// fixed of its camera.
struct SceneDescription {
  ObjectDescription object;
  CameraWishes camera;
  std::vector<Double3> lights;
  bool shadows = false;
  std::filesystem::path environment;
};

/// "#rrggbb", sRGB, as linear RGB; throws InputError for anything else.
[[nodiscard]] Color color_from_hex(const std::string& text);

/// The material of iso-value i.
[[nodiscard]] Material material_of(const MaterialDescription& description, std::size_t i);

}  // namespace isocast
