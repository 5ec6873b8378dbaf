// A branching tree of tubes, like blood vessels in a scan.
#pragma once

#include <isocast/data_gen/sample.h>

#include <cstdint>

namespace isocast {

/// A trunk that enters [-1, 1]^3 from below and forks `levels` times, its radii by Murray's law (C. D.
/// Murray: The physiological principle of minimum work, PNAS 12, 1926). 1 on the centre lines, 0.5 on the
/// walls, 0 from two radii on.
[[nodiscard]] Field vessel_field(std::uint64_t seed, int levels);

}  // namespace isocast
