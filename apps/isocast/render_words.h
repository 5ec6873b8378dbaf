// What the command line of render means.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/render/features.h>

#include <array>
#include <string>
#include <vector>

namespace isocast {

/// The command line as it was typed.
struct RenderWords {
  std::string input, output, iso, iso_sweep, colors, method = "auto", size = "1024x1024", isa = "auto",
                                                     precision = "float";
  std::string position, target, up, fov, ortho, normals = "gradient", aov, stats;
  std::string domain, time, opacity, reflectivity, environment, aa;
  std::vector<std::string> set, params, lights, clips;
  bool shadows = false, by_component = false;
  int spp = 1, threads = 0, transparency_depth = 4, reflections = 1;
  ReadOptions read;
  bool operator==(const RenderWords&) const = default;
};

/// The parts between separators; at least one.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// All of these throw InputError for words that cannot be used.
///
/// "WIDTHxHEIGHT" in pixels
[[nodiscard]] std::array<int, 2> parse_size(const std::string& text);

/// The iso-values of every frame: one frame of all of --iso, or one value a frame.
[[nodiscard]] std::vector<std::vector<double>> parse_frames(const RenderWords& words);

/// The layers of --aov, which only an EXR can hold.
[[nodiscard]] std::vector<Layer> parse_layers(const RenderWords& words, bool exr);

/// The looks of the iso-values, or of the components.
[[nodiscard]] MaterialDescription materials_of(const RenderWords& words);

/// What is fixed of the camera.
[[nodiscard]] CameraWishes camera_of(const RenderWords& words);

/// How the scene is evaluated, and how its picture is shaded.
[[nodiscard]] EvaluationSettings evaluation_of(const RenderWords& words);
[[nodiscard]] RenderSettings settings_of(const RenderWords& words);

/// The scene but its iso-values.
[[nodiscard]] SceneDescription describe(const RenderWords& words);

}  // namespace isocast
