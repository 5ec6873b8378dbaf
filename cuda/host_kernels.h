// Kernel bodies as functions of this processor.
#pragma once

#include <isocast/cuda/segment_work.h>
#include <isocast/implicit/segment_solver.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace isocast {

/// One thread of a kernel; `registers` is for interpreted formulas.
using HostKernel = void(const void* body, std::int32_t block, std::int32_t thread, std::int32_t threads,
                        void* registers);

/// Null for a name that no kernel has.
[[nodiscard]] HostKernel* host_volume_kernel(const std::string& name);
/// With the bytes that it needs for each register of the tape.
struct HostFormulaKernel {
  HostKernel* run;
  std::size_t register_bytes;
};

}  // namespace isocast
