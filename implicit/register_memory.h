// Memory for the registers of a tape.
#pragma once

#include <cstddef>

namespace isocast {

/// At least `bytes` for this thread, aligned to 64, until its next call.
[[nodiscard]] void* registers_of(std::size_t bytes);

}  // namespace isocast
