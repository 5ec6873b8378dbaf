// Those cells of a volume that a line may meet.
#pragma once

#include <isocast/apps/reference/volume_cells.h>

#include <span>

namespace isocast::reference {

struct CellCorners {
  Cell cell;
  double f[8];
};
/// All cells which the line meets and whose corners do not lie on one side of every iso-value, in any order,
/// and some that the line just misses. Nothing where that is too much work for one ray: some 10^5 such cells
/// or 10^7 blocks on the way.
[[nodiscard]] std::optional<std::vector<CellCorners>> cells_along(const VolumeCells& cells,
                                                                  const ExactLine& line,
                                                                  std::span<const double> iso);

}  // namespace isocast::reference
