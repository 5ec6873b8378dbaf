// The CUDA driver, found at run time.
#pragma once

#include <cuda.h>

#include <source_location>

namespace isocast {

/// The functions of libcuda that are used. The names are the driver's, of the versions that cuda.h has.
struct Driver {
  decltype(&::cuInit) init;
  decltype(&::cuDeviceGetCount) device_count;
  decltype(&::cuDeviceGet) device;
  decltype(&::cuDeviceGetName) device_name;
  decltype(&::cuDeviceGetAttribute) device_attribute;
  decltype(&::cuDevicePrimaryCtxRetain) retain_context;
  decltype(&::cuCtxSetCurrent) set_context;
  decltype(&::cuMemGetInfo) memory_info;
  decltype(&::cuMemAlloc) allocate;
  decltype(&::cuMemFree) free;
  decltype(&::cuMemcpyHtoDAsync) upload;
  decltype(&::cuMemcpyDtoHAsync) download;
  decltype(&::cuModuleLoadData) load_module;
  decltype(&::cuModuleGetFunction) find_function;
  decltype(&::cuLaunchKernel) launch;
  decltype(&::cuStreamCreate) make_stream;
  decltype(&::cuStreamDestroy) destroy_stream;
  decltype(&::cuStreamSynchronize) wait_for_stream;
  decltype(&::cuEventCreate) make_event;
  decltype(&::cuEventDestroy) destroy_event;
  decltype(&::cuEventRecord) record_event;
  decltype(&::cuEventElapsedTime) elapsed_time;
  decltype(&::cuGetErrorName) error_name;
  decltype(&::cuGetErrorString) error_text;
};

/// Opened at the first call. Throws InputError where there is no driver.
[[nodiscard]] const Driver& driver();

/// Throws std::runtime_error with the driver's words, file and line, for anything but success.
void check(CUresult result, std::source_location place = std::source_location::current());

}  // namespace isocast
