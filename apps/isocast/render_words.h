// What the command line of render means.
#pragma once

#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/render/features.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace isocast {

/// The command line as it was typed.
///
/// scene_text  of the viewer: stands instead of what is in the scene file `input`; all its files by their
///             full names
struct RenderWords {
  std::string input, output, iso, iso_sweep, colors, method = "auto", size, isa = "auto", precision = "float";
  std::string position, target, up, fov, ortho, normals = "gradient", aov, stats;
  std::string scene_text, frames, shard, exr_names = "plain", domain, time, opacity, reflectivity,
                                         environment, aa, camera, filter = "box", ambient_occlusion_radius;
  std::vector<std::string> set, params, lights, clips;
  bool shadows = false, by_component = false, resume = false;
  std::optional<int> spp, transparency_depth, reflections;  // not given: the scene's, or 1, 4 and 1
  int threads = 0, ambient_occlusion = 0;
  ReadOptions read;
  bool operator==(const RenderWords&) const = default;
};

/// A frame with what the command line changes in it.
///
/// iso   empty: those of the scene
/// time  none: the scene's
struct FrameJob {
  int number = 0;
  std::vector<double> iso = {};
  std::optional<double> time = {};
};

/// The parts between separators; at least one.
[[nodiscard]] std::vector<std::string> split(const std::string& text, char separator);

/// All of these throw InputError for words that cannot be used.
///
/// "WIDTHxHEIGHT" in pixels; empty: 1024x1024
[[nodiscard]] std::array<int, 2> parse_size(const std::string& text);

/// The layers of --aov, which only an EXR can hold.
[[nodiscard]] std::vector<Layer> parse_layers(const RenderWords& words, bool exr);

/// The looks of the iso-values, or of the components.
[[nodiscard]] MaterialDescription describe_materials(const RenderWords& words);

/// What the words fix of the camera, over what is fixed already.
void change_camera(const RenderWords& words, CameraWishes& camera);

/// How the scene is evaluated, and how its picture is shaded.
[[nodiscard]] EvaluationSettings evaluation_of(const RenderWords& words);
[[nodiscard]] RenderSettings settings_of(const RenderWords& words, const RenderWishes& wishes);

/// The scene that the words name, a file with what the words change of it, or one object, for all frames:
/// before its animation.
[[nodiscard]] SceneDescription describe_all(const RenderWords& words);
/// That scene at a frame.
[[nodiscard]] SceneDescription describe_frame(const RenderWords& words, const SceneDescription& all,
                                              const FrameJob& job);
/// The scene at the first of --frames, or its own first frame, but for the iso-values of --iso.
[[nodiscard]] SceneDescription describe(const RenderWords& words);

/// The size of the picture: the words', else the scene's, else 1024x1024.
[[nodiscard]] std::array<int, 2> size_of(const RenderWords& words, const SceneDescription& scene);

}  // namespace isocast
