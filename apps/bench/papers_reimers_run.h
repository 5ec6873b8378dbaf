// The surfaces of Reimers and Seland through the root finders of the frustum form, and what was found.
#pragma once

#include <isocast/apps/bench/paper.h>
#include <isocast/apps/bench/papers_reimers_picture.h>
#include <isocast/apps/bench/papers_reimers_tables.h>

#include <cmath>
#include <map>
#include <span>

namespace isocast::bench {

/// Of the paper's tables first, then the others that it tried.
inline constexpr const char* kFinders[] = {"frustum-lr",      "frustum-lr-mult",   "frustum-mr",
                                           "frustum-mr-mult", "frustum-schneider", "frustum-clip"};
/// Two eps of LR by |f|, between which what an accuracy costs is interpolated.
inline constexpr const char* kValueEps[] = {"0.005", "5e-05"};
/// eps at which the neck of Kiss is looked at beside 5e-4, and the neck: |z| below.
inline constexpr const char* kNeckEps[] = {"0.05", "0.005", "5e-05", "5e-06", "5e-07"};
inline constexpr double kNeck = 0.25;
/// Surfaces that are seen in a larger domain by the same camera, the singular one first; how much longer, and
/// their eps there, which is about as long.
inline constexpr std::string_view kLargeSurfaces[] = {"heart_taubin", "tangle"};
inline constexpr double kLarge = 8;
inline constexpr const char* kLargeEps = "0.0001";
[[nodiscard]] std::string large_case(std::string_view id);

class ReimersRun {
 public:
  explicit ReimersRun(const PaperWishes& wishes);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::vector<Row> rows() const;

  /// Null where it was not run.
  [[nodiscard]] const FinderResult* result(std::string_view case_name, const MethodSetting& setting,
                                           bool precise = false) const;
  /// Null where the surface was not run.
  [[nodiscard]] const ShadingNumbers* shading(std::string_view id) const;

  /// number(surface) of every surface that was run, with a degree from `least` to `most`.
  template <class Number>
  [[nodiscard]] std::vector<double> each(Number number, int least = 0, int most = kMostFormDegree) const {
    std::vector<double> all;
    for (const SurfaceOfReimers& s : kReimersSurfaces)
      if (shading(s.id) && s.degree >= least && s.degree <= most) all.push_back(number(s));
    return all;
  }
  /// Of surfaces that were run: how many times as long one takes as another.
  [[nodiscard]] double time_ratio(const SurfaceOfReimers& s, const MethodSetting& slow,
                                  const MethodSetting& fast) const {
    return result(s.id, slow)->row.seconds / result(s.id, fast)->row.seconds;
  }
  /// Of LR's pass: what its searches take. Measured by what it takes without going on after one
  /// subdivision, which counts for all of them.
  [[nodiscard]] double root_seconds(const SurfaceOfReimers& s) const;
  /// How many times as many subdivisions LR takes by |f| as by density at 5e-4, for the same median error, in
  /// double.
  [[nodiscard]] double cost_of_value_rule(const SurfaceOfReimers& s) const;
  /// Knots a ray, a subdivision being `degree` of them.
  [[nodiscard]] double knots(const SurfaceOfReimers& s, const MethodSetting& setting) const;

 private:
  void run(const PaperWishes& wishes, const PictureCase& picture, const std::vector<FinderWay>& ways,
           const Box& part = {});

  int size_;
  std::map<std::string, ReimersFindings, std::less<>> cases_;
};

[[nodiscard]] std::vector<Claim> reimers_claims(const ReimersRun& run);

}  // namespace isocast::bench
