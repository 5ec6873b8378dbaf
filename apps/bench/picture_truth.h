// What is true of every pixel of a picture, and what a method makes of it.
#pragma once

#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/picture_case.h>
#include <isocast/apps/bench/rows.h>

#include <span>
#include <vector>

namespace isocast::bench {

/// By pixel, rows from the top.
///
/// rays     without roots where the ray passes beside the domain
/// normals  at the first crossing, of unit length and turned against the ray; zero where none is known
/// unit     of errors, a world length
struct PictureTruth {
  std::vector<reference::RayTruth> rays;
  std::vector<Double3> normals;
  double unit = 1;
};

/// Rays that the reference leaves undecided.
[[nodiscard]] std::int64_t undecided_rays(const PictureTruth& truth);

/// Fills in the normals. `hits` are those of a method in double precision: where they are right, the surface
/// is asked for its normal at the true root in their cell.
void add_normals(PictureTruth& truth, const Surface& surface, const std::vector<RayStream>& rays,
                 std::vector<HitStream> hits);

/// One pixel's answer. Errors mean something for hits only: of t in units, of the normal in degrees (NaN
/// where one of the two is unknown).
struct PixelAnswer {
  Verdict verdict = Verdict::miss;
  double t_error = 0, normal_error_deg = 0;
};

/// By pixel. Normals are those that the surface dresses its hits with.
[[nodiscard]] std::vector<PixelAnswer> judge_picture(const PictureTruth& truth, const Surface& surface,
                                                     const std::vector<RayStream>& rays,
                                                     const std::vector<HitStream>& hits);

/// The columns that hold errors and counts.
void summarize(std::span<const PixelAnswer> answers, Row& row);

}  // namespace isocast::bench
