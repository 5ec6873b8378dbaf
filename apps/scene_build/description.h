// What the user asked for, as plain data: nothing is loaded yet.
#pragma once

#include <isocast/render/camera.h>
#include <isocast/scene/scene.h>
#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/volume_surface.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace isocast {

/// Iso-surfaces of a volume file. `iso` in the file's scaled units; empty: the best of suggested_iso.
/// `colors` are repeated over the iso-values; empty: the default palette.
struct VolumeDescription {
  std::filesystem::path file;
  ReadOptions read;
  std::vector<double> iso;
  std::vector<Color> colors;
  std::string method = "auto";
  std::map<std::string, std::string> settings;
  NormalKind normals = NormalKind::gradient;
};

/// A scene of one volume, its light, and what is fixed of its camera.
struct SceneDescription {
  VolumeDescription volume;
  CameraWishes camera;
  std::optional<Double3> light;
  bool shadows = false;
};

/// "#rrggbb", sRGB, as linear RGB; throws InputError for anything else.
[[nodiscard]] Color color_from_hex(const std::string& text);

/// The colour of iso-value i where none is given.
[[nodiscard]] Color default_color(std::size_t i);

}  // namespace isocast
