// Error against condition for every method and precision of one case, as SVG.
#pragma once

#include <isocast/apps/bench/condition.h>

#include <span>
#include <string>

namespace isocast::bench {

/// The condition's decades to the right, errors upwards on a logarithmic axis, 0 in a lane below. Marks are
/// medians, whiskers reach to the maximum; double is hollow. `methods` are in the order of their colours.
/// Below each decade stands its number of rays.
[[nodiscard]] std::string condition_plot(std::span<const ConditionCurve> curves,
                                         const std::vector<std::string>& methods, const std::string& unit);

}  // namespace isocast::bench
