// A CUDA device as an engine.
#pragma once

#include <isocast/cuda/engine.h>

namespace isocast {

/// The first device. Throws InputError where there is no driver or no device, or the device is older than the
/// kernels (compute capability 7.5). Volume kernels are in the program; formulas are compiled by NVRTC when
/// they are met.
[[nodiscard]] std::shared_ptr<const Engine> make_device_engine();

}  // namespace isocast
