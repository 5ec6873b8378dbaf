// The surfaces of Singh and Narayanan through marching points, and what was found.
#pragma once

#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_singh_tables.h>

#include <span>

namespace isocast::bench {

/// Settings as in the paper: the sign test and the Taylor test with a base step; the sign test on the Chmutov
/// octic by its tau1, and on the Steiner surface with an offset; Knoll's affine forms beside them.
[[nodiscard]] MethodSetting sign_test(double step);
[[nodiscard]] MethodSetting taylor_test(double step);
[[nodiscard]] MethodSetting octic_test(double tau1);
[[nodiscard]] MethodSetting fattened_test();
[[nodiscard]] MethodSetting knoll_test();

/// Surfaces that are touched or have two sheets close to each other, and those that the paper gives the
/// smallest steps, with the wider one that they are tried with.
inline constexpr std::string_view kTouchingSurfaces[] = {"steiner_singh", "cross_cap", "miter", "kiss",
                                                         "high_silhouette"};
inline constexpr std::string_view kSmallStepSurfaces[] = {"endrass_octic", "hunt"};
inline constexpr double kWideStep = 0.03;

/// The surfaces of all tables, on scalars and the widest instruction set, in float.
class SinghRun {
 public:
  explicit SinghRun(const PaperWishes& wishes);

  [[nodiscard]] Isa wide() const { return wide_; }
  [[nodiscard]] std::vector<Row> take_rows() { return rows_.take(); }

  /// On the widest instruction set; null where it was not run.
  [[nodiscard]] const Row* row(std::string_view id, const MethodSetting& s) const {
    return rows_.find(id, s.method, s.text, wide_);
  }
  /// NaN where it was not run.
  [[nodiscard]] double seconds(std::string_view id, const MethodSetting& s) const {
    return rows_.seconds(id, s.method, s.text, wide_);
  }
  /// Frames of size x size a second; NaN where it was not run.
  [[nodiscard]] double frames(std::string_view id, const MethodSetting& s, Isa isa, double size = 512) const;

  /// number(surface, row of the sign test) of every surface of the first table that was run.
  template <class Number> [[nodiscard]] std::vector<double> everywhere(Number number) const {
    std::vector<double> all;
    for (const SurfaceOfSingh& s : kSinghSurfaces)
      if (const Row* const found = row(s.id, sign_test(s.step))) all.push_back(number(s, *found));
    return all;
  }
  /// A column, summed over some surfaces; setting(step of the first table).
  template <class Setting>
  [[nodiscard]] double sum(std::int64_t Row::*column, std::span<const std::string_view> ids,
                           Setting setting) const {
    double total = 0;
    for (const std::string_view id : ids)
      for (const SurfaceOfSingh& s : kSinghSurfaces)
        if (const Row* const found = s.id == id ? row(id, setting(s.step)) : nullptr)
          total += static_cast<double>(found->*column);
    return total;
  }

 private:
  void run(const PaperWishes& wishes, std::string_view id, const std::vector<MethodSetting>& settings);

  Isa wide_ = widest_isa();
  PaperRows rows_;
};

}  // namespace isocast::bench
