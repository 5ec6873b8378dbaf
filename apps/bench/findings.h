// What the rows of a report say, in sentences.
#pragma once

#include <isocast/apps/bench/case_finding.h>

#include <span>
#include <string>
#include <vector>

namespace isocast::bench {

/// Best methods, failures, what instruction sets buy, what double costs and buys, where float ends: five
/// sentences, fewer where the rows do not tell.
[[nodiscard]] std::vector<std::string> findings(std::span<const CaseRows> cases);

}  // namespace isocast::bench
