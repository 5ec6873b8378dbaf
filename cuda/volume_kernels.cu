// The kernels of volumes, nothing but their names: ISO_PRECISION, ISO_EACH_GRID_OF pick some.
#include <isocast/cuda/volume_body.h>

using namespace isocast;

#define ISO_NAME(T, name) trace_##T##_##name
#define ISO_KERNEL(T, name, ...)                                                           \
  extern "C" __global__ void __launch_bounds__(128, 2)                                        \
      ISO_NAME(T, name)(const __grid_constant__ TraceVolume<T, __VA_ARGS__> body) {        \
    body({std::int32_t(blockIdx.x), std::int32_t(threadIdx.x), std::int32_t(blockDim.x)}); \
  }
ISO_EACH_GRID_OF(ISO_KERNEL, ISO_PRECISION)
