// One picture through the root finders of the frustum form, as whole pictures: what they find, how many steps
// they take, and what their passes and what follows them cost.
#pragma once

#include <isocast/apps/bench/papers_reimers_search.h>
#include <isocast/apps/bench/sweeps.h>
#include <isocast/apps/bench/timing.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// eps 5e-4 and nothing proved, as the paper ran it, unless `set` has its own.
[[nodiscard]] MethodSetting finder(const std::string& method, std::map<std::string, std::string> set = {});
/// The paper's reference: MR at eps 1e-8, in double.
[[nodiscard]] MethodSetting reference_finder();

struct FinderWay {
  MethodSetting setting;
  bool precise = false;
};

/// Seconds a picture on one thread: normals of its hits from gradients, from neighbours and from the frustum
/// form (with what LR's pass takes longer for them); frames by LR, with shading, with silhouettes blended in
/// and of four samples a pixel.
///
/// angle, form_angle  between gradients and neighbours' normals, the form's normals, away from edges: median,
///                    degrees
/// hits               whose normals they are
struct ShadingNumbers {
  double gradients = 0, neighbours = 0, form = 0, frame = 0, silhouettes = 0, four_samples = 0, angle = 0,
         form_angle = 0;
  std::int64_t hits = 0;
};

/// Errors in the row: of every 61st ray, against the exact reference; the others are in undecided_reference.
struct FinderResult {
  Row row;
  SearchNumbers search;
};

/// part  of the world that SearchNumbers looks at; empty: none
struct ReimersWishes {
  std::vector<FinderWay> ways;
  Box part = {};
  Repetitions repetitions = {3, 9, 2.0};
  std::filesystem::path cache;
};
struct ReimersFindings {
  std::vector<FinderResult> results;
  ShadingNumbers shading;
};

/// A picture of a polynomial of degree kMostFormDegree at most, large enough for forms: some 250 pixels. The
/// reference finder comes first, whatever is wished.
[[nodiscard]] ReimersFindings run_finders(const PictureCase& picture, const ReimersWishes& wishes);

}  // namespace isocast::bench
