// The module `cuda`.
#include <isocast/base/module.h>
#include <isocast/cuda/cuda_module.h>
#include <isocast/cuda/device_engine.h>
#include <isocast/cuda/formula_device.h>
#include <isocast/cuda/host_engine.h>
#include <isocast/cuda/volume_device.h>

#include <cstdlib>
#include <string_view>

namespace isocast {
namespace {

std::shared_ptr<const ComputeDevice> open() {
  const char* const wanted = std::getenv("ISOCAST_CUDA_ENGINE");
  const std::shared_ptr<const Engine> engine =
      wanted && std::string_view(wanted) == "host" ? make_host_engine() : make_device_engine();
  const auto pool = std::make_shared<const QueuePool>(engine);
  return std::make_shared<ComputeDevice>(ComputeDevice{engine->name(), make_volume_device(pool),
                                                       make_formula_device(pool),
                                                       [pool] { return pool->seconds(); }});
}

const CudaModule module = {open};

}  // namespace
}  // namespace isocast

ISO_EXPORT_MODULE(isocast::module)
