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
/// and some that the line just misses.
[[nodiscard]] std::vector<CellCorners> cells_along(const VolumeCells& cells, const ExactLine& line,
                                                   std::span<const double> iso);

}  // namespace isocast::reference
