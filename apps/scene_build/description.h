// What the user asked for, as plain data: nothing is loaded yet.
#pragma once

#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/csg_surface.h>
#include <isocast/render/camera.h>
#include <isocast/scene/scene.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/volume_surface.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace isocast {

struct ObjectDescription;

struct VolumeSource {
  std::filesystem::path file;
  ReadOptions read;
};
/// text, parameters  what the expression was made of, in a scene file (formula_input.h): parameters may be
///                   animated
struct FormulaSource {
  Expression expression;
  Domain domain;
  double time = 0;
  std::string text = {};
  Parameters parameters = {};
};
/// Triangles of an .obj or .ply file.
struct MeshSource {
  std::filesystem::path file;
};
/// A solid of closed objects; subtract: the first without all the others.
struct CsgSource {
  CsgOperation operation = CsgOperation::unite;
  std::vector<ObjectDescription> of;
};
/// The object of that name once more at each of the places, with materials of its own where there are some.
struct InstanceSource {
  std::string of;
  std::vector<Transform> places;
};

/// Each list is repeated over the iso-values. Empty: the default palette, opaque, without reflections, and
/// Material's highlight.
struct MaterialDescription {
  std::vector<Color> colors;
  std::vector<double> opacities, reflectivities, speculars = {};
  bool operator==(const MaterialDescription&) const = default;
};

/// The points where the formula is not positive at this time.
struct SolidDescription {
  Expression formula;
  double time = 0;
};

/// Colours from another field at the exact hit: a volume's interpolated value or a formula's, from `lo` to
/// `hi` along a map (color_map.h). Without a range: the volume's, or [-1, 1].
struct ColorBy {
  std::variant<VolumeSource, FormulaSource> field;
  std::string map = "viridis";  // a name or a ParaView .json
  std::optional<std::array<double, 2>> range = {};
  bool logarithmic = false;
  std::optional<Color> nan_color = {};  // else the map's
};

/// Iso-surfaces of a volume (`iso` in the file's scaled units; empty: the best of suggested_iso) or of a
/// formula in a box (empty: 0), a mesh, a solid of others, or copies of one. `by_component`: the materials
/// are those of the operands of the min and max in which the formula ends. place: from its own space into the
/// world's. `clips`: only what lies in all of them is there, in the world's space. time: its own; else it
/// follows the scene's. visible: else nothing of it is there but its instances.
struct ObjectDescription {
  std::string name = {};
  std::variant<VolumeSource, FormulaSource, MeshSource, CsgSource, InstanceSource> source = {};
  std::vector<double> iso = {};
  MaterialDescription materials = {};
  std::string method = "auto";
  std::map<std::string, std::string> settings = {};
  NormalKind normals = NormalKind::gradient;
  bool by_component = false;
  std::vector<SolidDescription> clips = {};
  Transform place = {};
  std::optional<ColorBy> color_by = {};
  std::optional<double> time = {};
  bool visible = true;
};

/// What is fixed at a frame; what a key does not name is interpolated between those that do.
struct AnimationKey {
  int frame = 0;
  std::optional<double> time;
  std::optional<CameraWishes> camera;
  std::map<std::string, double> parameters;        // "object.name"
  std::map<std::string, std::vector<double>> iso;  // by object
};
/// Frames first to last; keys by rising frame. Without keys: the numbers of file sequences only.
struct Animation {
  int first = 0, last = 0;
  std::vector<AnimationKey> keys;
};

/// How a scene wants to be rendered, where the command line does not say.
struct RenderWishes {
  std::optional<std::array<int, 2>> size;
  std::optional<int> spp, transparency_depth, reflections;
};

/// A scene of one object until others are added, its lights and environment (a picture of all directions;
/// empty: none), and what is fixed of its camera.
///
/// clips              of all objects
/// cameras            by name; `camera` is the one in use
struct SceneDescription {
  std::vector<ObjectDescription> objects = std::vector<ObjectDescription>(1);
  std::vector<SolidDescription> clips;
  CameraWishes camera;
  std::map<std::string, CameraWishes> cameras;
  std::vector<Double3> lights;
  bool shadows = false;
  AmbientOcclusion ambient_occlusion;
  Color background = {1, 1, 1};
  std::filesystem::path environment;
  double time = 0;
  std::optional<Animation> animation;
  RenderWishes wishes;

  /// Everything that cuts an object: its own solids and the scene's.
  [[nodiscard]] std::vector<SolidDescription> clips_of(std::size_t object) const;
};

/// "#rrggbb", sRGB, as linear RGB; throws InputError for anything else.
[[nodiscard]] Color color_from_hex(const std::string& text);

/// The material of iso-value i.
[[nodiscard]] Material material_of(const MaterialDescription& description, std::size_t i);

}  // namespace isocast
