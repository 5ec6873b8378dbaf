// A scene at one of its frames.
#pragma once

#include <isocast/apps/scene_build/description.h>

namespace isocast {

/// The scene at a frame, any number: a function of the two and of nothing else. File sequences get the
/// frame's number; time, camera, parameters and iso-values are interpolated linearly between the keys that
/// name them, and stay as they are before the first and behind the last of these. A name with a %d that a
/// frame cannot fill, a parameter that an object has not, and lists of iso-values of different length throw
/// InputError.
[[nodiscard]] SceneDescription description_at(const SceneDescription& scene, int frame);

/// The scene at another time: of all formulas that have none of their own.
[[nodiscard]] SceneDescription at_time(const SceneDescription& scene, double time);

/// The first and the last frame: without an animation 0 and 0.
[[nodiscard]] std::array<int, 2> frames_of(const SceneDescription& scene);

/// Whether frames differ in more than their cameras and the iso-values of volumes and formulas.
[[nodiscard]] bool rebuilt_by_frames(const SceneDescription& scene);

/// "ct_%04d.nrrd" with the frame's number; a name without % stays. Throws InputError for any other use of %.
[[nodiscard]] std::filesystem::path numbered_file(const std::filesystem::path& file, int frame);

/// The least and the largest frame that a numbered name has a file for; none: there is no such file.
[[nodiscard]] std::optional<std::array<int, 2>> numbers_of_files(const std::filesystem::path& file);

}  // namespace isocast
