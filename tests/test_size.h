// Two sizes for property tests: quick in ./check, full in ./check --nightly.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace isocast::test {

/// `quick` cases normally, `nightly` cases when ISOCAST_NIGHTLY is set (the ctest label nightly sets it).
inline std::int64_t cases(std::int64_t quick, std::int64_t nightly) {
  return std::getenv("ISOCAST_NIGHTLY") ? nightly : quick;
}

}  // namespace isocast::test
