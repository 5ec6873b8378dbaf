// Which rows nothing else beats in both error and run time.
#pragma once

#include <isocast/apps/bench/rows.h>

#include <vector>

namespace isocast::bench {

/// One number for a row: the mean error, and one whole voxel (or domain width) for every ray that was
/// answered wrongly or not at all.
[[nodiscard]] double pareto_error(const Row& row);

/// Sets `pareto` where no row of the same suite, case, instruction set and precision has less of one of
/// pareto_error and seconds and not more of the other.
void mark_pareto(std::vector<Row>& rows);

}  // namespace isocast::bench
