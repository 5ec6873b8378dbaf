// One picture case through every method: errors once, times in turns.
#pragma once

#include <isocast/apps/bench/condition.h>
#include <isocast/apps/bench/small_picture.h>
#include <isocast/apps/bench/sweeps.h>
#include <isocast/apps/bench/timing.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// chosen      what is run; empty: what `settings` asks for
/// isas        which are timed; the last is that of the sweeps. Errors are the same on all
/// device      what is timed instead, if there is one: "cuda" are its kernels, by its own clock, "cuda-wall"
/// the whole calls,
///             with transfers. Methods that it lacks are left out
/// precisions  "float", "double"; the first is that of the sweeps
/// repetitions of every timed run, in turns
/// cache       the folder in which the reference's answers are kept; empty: nowhere
struct PictureOptions {
  SettingWishes settings;
  std::vector<MethodSetting> chosen = {};
  std::vector<Isa> isas = available_isas();
  std::shared_ptr<const ComputeDevice> device = {};
  std::vector<std::string> precisions = {"float", "double"};
  Repetitions repetitions = {3, 15, 12.0};
  std::filesystem::path cache = {};
};

/// A method as it is meant to run, in one precision, pixel by pixel.
struct PictureAnswers {
  std::string method, precision;
  std::vector<PixelAnswer> pixels;
};

/// Everything that was found out about a case.
///
/// rows             marked where nothing else of the case beats them
/// answers          of the methods as they are meant to run
/// harness_seconds  of the clock's time, what is spent around the surface's own work
struct PictureResult {
  PictureCase picture;
  PictureTruth truth;
  std::string unit_name;
  std::vector<double> iso;
  std::vector<Row> rows;
  std::vector<PictureAnswers> answers;
  SmallPicture right;
  double harness_seconds = 0;
};

/// Times are of first_hit over all primary rays on one thread. Throws InputError for what cannot be built.
[[nodiscard]] PictureResult run_picture(const PictureCase& picture, const PictureOptions& options);

}  // namespace isocast::bench
