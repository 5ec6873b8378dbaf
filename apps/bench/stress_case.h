// A case of the suite `stability`: what is hard about it, its rays, and what is expected of which method.
#pragma once

#include <isocast/apps/bench/stress_rays.h>
#include <isocast/apps/scene_build/description.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// What is counted of a method's answers, in per cent of the rays. wrong: false hits and misses and wrong
/// roots; proved_hit and proved_miss: certificates.
enum class Counted { wrong, undecided, proved_hit, proved_miss };

/// Stands for all methods that prove hits and misses by inclusions of f. Those on forms leave open what is badly
/// conditioned as a polynomial of its ray; their proofs are held against the truth as all others are.
inline constexpr std::string_view kProving = "proving";

/// Between `least` and `most` per cent. Empty names stand for all methods and both precisions. Of every case
/// two things more are expected (stress_judge.h): no proof is false, no answer is malformed.
struct Expectation {
  Counted counted;
  double least, most;
  std::string_view method = "", precision = "";
};

/// stresses  what is hard, in a sentence
/// scene     of one object, with its method left to be chosen
struct StressCase {
  std::string name, stresses;
  SceneDescription scene;
  MakeRays rays;
  std::vector<Expectation> expected;
};

/// A family of cells (cell_families.h), of which it is the name.
struct StressFamily {
  std::string_view name;
  std::vector<Expectation> expected;
};

[[nodiscard]] std::vector<StressCase> stress_formulas();
/// Volumes are written to folder/volumes/NAME.nrrd.
[[nodiscard]] std::vector<StressCase> stress_volumes(const std::filesystem::path& folder);
/// All families, in their order.
[[nodiscard]] std::vector<StressFamily> stress_families();

}  // namespace isocast::bench
