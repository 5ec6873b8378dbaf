// The cells of Marmitt et al. through their intersectors, and what was found.
#pragma once

#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_marmitt_tables.h>
#include <isocast/apps/bench/volume_chords.h>

namespace isocast::bench {

/// The intersectors as the paper set them, and some that its claims speak of: Neubauer with ten iterations
/// and with bilinear ends, the new method with an adaptive stop.
enum class Tried { midpoint, linear, neubauer, schwarze, marmitt, ten, face, adaptive };
[[nodiscard]] const std::vector<CellSetting>& settings_of_marmitt();

/// Synthetic cells and scans, on scalars and four lanes, in both precisions.
class MarmittRun {
 public:
  explicit MarmittRun(const PaperWishes& wishes);

  /// Four lanes.
  [[nodiscard]] Isa simd() const { return simd_; }
  /// Names of cases, and a sentence about each scan.
  [[nodiscard]] const std::vector<std::string>& synthetic() const { return synthetic_; }
  [[nodiscard]] const std::vector<std::string>& scans() const { return scans_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Chords with two crossings.
  [[nodiscard]] double two_roots() const { return two_roots_; }
  [[nodiscard]] std::vector<Row> take_rows() { return rows_.take(); }

  [[nodiscard]] const Row& row(const std::string& name, Tried tried, Isa isa,
                               std::string_view precision = "float") const;
  /// How much faster one is than another, case by case.
  [[nodiscard]] std::vector<double> ratios(const std::vector<std::string>& names, Tried fast, Isa fast_isa,
                                           Tried slow, Isa slow_isa) const;
  /// A column summed over all cells.
  [[nodiscard]] double sum(std::int64_t Row::*column, Tried tried,
                           std::string_view precision = "float") const;
  [[nodiscard]] double failures(Tried tried, std::string_view precision) const;

 private:
  void run(CellCase cells, std::vector<std::string>& group);
  void run_family(const CellFamily& family);
  void run_scan(const ScanOfPaper& scan);

  const PaperWishes& wishes_;
  Isa simd_;
  PaperRows rows_;
  std::vector<std::string> synthetic_, scans_, notes_;
  double two_roots_ = 0;
};

}  // namespace isocast::bench
