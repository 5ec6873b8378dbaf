// One damaged copy of a whole file, always the same for the same number.
#pragma once

#include <cstdint>

#include "made_file.h"

namespace isocast::hostile {

/// What a reader must make of a file; a damaged one may still hold a volume.
enum class Expected { volume, either, error };

struct Mutant {
  std::string name, bytes;
  Expected expected;
};

/// Number n of the mutants of a file: cut short, bits flipped, bytes or written numbers at their extremes,
/// pieces removed or repeated; mostly in the head.
[[nodiscard]] Mutant mutant(const MadeFile& file, std::uint64_t n);

}  // namespace isocast::hostile
