// report.html of the suite `stability`.
#pragma once

#include <isocast/apps/bench/stability.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// A document that refers to nothing outside itself: an overview, and of each case what is stressed, what is
/// expected and whether that holds, and a table of methods.
[[nodiscard]] std::string stability_html(const std::vector<StressResult>& results,
                                         const Provenance& provenance);

}  // namespace isocast::bench
