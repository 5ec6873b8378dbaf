// The cells of a volume as the reference sees them.
#pragma once

#include <isocast/apps/reference/exact_line.h>
#include <isocast/volume/volume.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace isocast::reference {

/// Cells origin ... origin + 2^shift - 1 per axis.
struct CellBlock {
  Cell origin;
  int shift;
};

/// Samples as doubles (i64 beyond 2^53: the nearest), by the plainest way to them: no ranges, no keys.
class VolumeCells {
 public:
  virtual ~VolumeCells() = default;

  /// The eight corners of a cell, x fastest; false where there is none: a corner that is not finite, or of a
  /// sparse grid none that is active.
  [[nodiscard]] virtual bool corners(const Cell& cell, double (&f)[8]) const = 0;
  /// The one value of all cells of a block, where that is plain to see; NaN where there are none.
  [[nodiscard]] virtual std::optional<double> uniform(const CellBlock& block) const = 0;
  /// Hash of all that decides what the others say.
  [[nodiscard]] virtual std::string identity() const = 0;

  /// There are cells between these samples only, none where first > last; and in these blocks.
  Cell first, last;
  std::vector<CellBlock> blocks;
};
/// Keeps the volume alive. Throws InputError for a dense one with fewer than two samples along an axis.
[[nodiscard]] std::unique_ptr<VolumeCells> cells_of(std::shared_ptr<const Volume> volume);

}  // namespace isocast::reference
