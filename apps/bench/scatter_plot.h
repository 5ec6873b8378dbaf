// Error against run time of all rows of one case, as SVG.
#pragma once

#include <isocast/apps/bench/rows.h>

#include <span>
#include <string>
#include <vector>

namespace isocast::bench {

/// The methods of some rows, in order of their first: that of their colours.
[[nodiscard]] std::vector<std::string> methods_of(std::span<const Row> rows);

/// Both axes logarithmic: seconds to the right, pareto_error upwards; rows without error lie in a lane of
/// their own below. Colour is the method, shape the instruction set, hollow is double; small marks are swept
/// settings, and thin lines join them. Broad lines are the fronts, as the rows of the last instruction set
/// are marked, dotted in double. Every mark has its numbers as a <title>.
[[nodiscard]] std::string scatter_plot(std::span<const Row> rows, const std::string& unit);

}  // namespace isocast::bench
