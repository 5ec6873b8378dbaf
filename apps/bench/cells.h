// The suite `cells`: every cell intersector on every family of cells.
#pragma once

#include <isocast/apps/bench/rows.h>
#include <isocast/isa/cpu.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// quick: six families with fewer rays. isas: which are timed; errors are the same on all, and computed once.
struct CellSuiteOptions {
  bool quick = false;
  std::vector<Isa> isas = available_isas();
};

/// t errors are |s - s_reference| times the chord's length, in voxels; normal errors the angle between the
/// gradients of the trilinear field at the two points. Seconds are the processor time of one thread.
[[nodiscard]] std::vector<Row> run_cells(const CellSuiteOptions& options);

/// The ratios of run times that the paper speaks of, as a table to read; of all rows of run_cells.
[[nodiscard]] std::string cell_summary(const std::vector<Row>& rows);

}  // namespace isocast::bench
