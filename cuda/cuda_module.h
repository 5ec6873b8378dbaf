// What the module `cuda` offers to scene_build.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace isocast {

class VolumeDevice;
class FormulaDevice;

/// What --isa cuda uses.
///
/// seconds  that all kernels have taken so far, by the device's clock; transfers are not in it
struct ComputeDevice {
  std::string name;
  std::shared_ptr<const VolumeDevice> volumes;
  std::shared_ptr<const FormulaDevice> formulas;
  std::function<double()> seconds;
};

struct CudaModule {
  /// The first device, or with the environment variable ISOCAST_CUDA_ENGINE=host this processor in its place
  /// (for tests: the same kernels, slowly). Throws InputError where there is no device.
  std::shared_ptr<const ComputeDevice> (*open)();
};

}  // namespace isocast
