// One thread of a launch, on a device or on this processor, and what threads do together.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast::inline ISO_ISA {

/// Threads of a block are numbered from 0; blocks too, all of one size.
struct Place {
  std::int32_t block, thread, threads;
  /// The thread's number among all.
  [[nodiscard]] ISO_HD std::int64_t number() const { return std::int64_t(block) * threads + thread; }
};

/// Adds to a counter that all threads share; returns what it was.
ISO_HD inline std::int64_t add_shared(std::int64_t& counter, std::int64_t more) {
  static_assert(sizeof(unsigned long long) == sizeof counter);
#ifdef __CUDA_ARCH__
  return static_cast<std::int64_t>(
      atomicAdd(reinterpret_cast<unsigned long long*>(&counter), static_cast<unsigned long long>(more)));
#else
  return (counter += more) - more;
#endif
}
ISO_HD inline std::int32_t add_shared(std::int32_t& counter, std::int32_t more) {
#ifdef __CUDA_ARCH__
  return atomicAdd(&counter, more);
#else
  return (counter += more) - more;
#endif
}

}  // namespace isocast::inline ISO_ISA
