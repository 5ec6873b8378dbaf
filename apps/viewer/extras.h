// What takes its time and is shown as it comes, once the picture is complete.
#pragma once

#include <isocast/apps/viewer/idle_work.h>

#include <functional>

namespace isocast::viewer {

/// One method in the current view: its time for a million rays in all threads, and its error against the
/// reference on a lattice of pixels.
///
/// error      median of |t - t_reference| |d| over right hits, in `unit`s; NaN without any
/// wrong      pixels of the lattice where it misses, hits or takes another root than the first, of `known`
struct MethodPoint {
  std::string method;
  double ms_per_megaray = 0, error = 0;
  int wrong = 0, known = 0;
};

/// What follows is of one object, which has methods; the scene is left as it was, and Interrupted is thrown.
///
/// The picture with another method, as screen pixels. Throws InputError for a method that does not apply.
[[nodiscard]] std::vector<std::uint8_t> other_picture(const JobScene& scene, std::size_t object,
                                                      const std::string& method);

/// The errors of the object's depths, as if it were alone, against the reference over the picture, first
/// every 16th pixel, at last each: from dark (1e-8 voxels or domain widths) to bright (1); red: a hit that is
/// none, or none where one is; grey: the reference does not know.
void show_errors(const JobScene& scene, std::size_t object, const std::function<void(Picture)>& show);

/// All applicable methods as they are, one after the other, of the object as if it were alone.
void find_points(const JobScene& scene, std::size_t object,
                 const std::function<void(const std::vector<MethodPoint>&)>& show);

}  // namespace isocast::viewer
