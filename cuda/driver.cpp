#include <isocast/cuda/driver.h>
#include <isocast/cuda/library.h>

#include <stdexcept>

namespace isocast {
namespace {

// cuda.h gives some functions new names where their arguments have changed: those are the symbols.
#define ISO_SYMBOL_TEXT(symbol) #symbol
#define ISO_SYMBOL(symbol) ISO_SYMBOL_TEXT(symbol)

template <class Function> void find(const SharedLibrary& library, const char* symbol, Function& function) {
  library.find(symbol, function);
}

Driver open_driver() {
  const SharedLibrary library(
      {"libcuda.so.1"}, "--isa cuda needs an NVIDIA GPU and its driver: libcuda.so.1 is not on this machine");
  Driver d = {};
  find(library, ISO_SYMBOL(cuInit), d.init);
  find(library, ISO_SYMBOL(cuDeviceGetCount), d.device_count);
  find(library, ISO_SYMBOL(cuDeviceGet), d.device);
  find(library, ISO_SYMBOL(cuDeviceGetName), d.device_name);
  find(library, ISO_SYMBOL(cuDeviceGetAttribute), d.device_attribute);
  find(library, ISO_SYMBOL(cuDevicePrimaryCtxRetain), d.retain_context);
  find(library, ISO_SYMBOL(cuCtxSetCurrent), d.set_context);
  find(library, ISO_SYMBOL(cuMemGetInfo), d.memory_info);
  find(library, ISO_SYMBOL(cuMemAlloc), d.allocate);
  find(library, ISO_SYMBOL(cuMemFree), d.free);
  find(library, ISO_SYMBOL(cuMemcpyHtoDAsync), d.upload);
  find(library, ISO_SYMBOL(cuMemcpyDtoHAsync), d.download);
  find(library, ISO_SYMBOL(cuModuleLoadData), d.load_module);
  find(library, ISO_SYMBOL(cuModuleGetFunction), d.find_function);
  find(library, ISO_SYMBOL(cuLaunchKernel), d.launch);
  find(library, ISO_SYMBOL(cuStreamCreate), d.make_stream);
  find(library, ISO_SYMBOL(cuStreamDestroy), d.destroy_stream);
  find(library, ISO_SYMBOL(cuStreamSynchronize), d.wait_for_stream);
  find(library, ISO_SYMBOL(cuEventCreate), d.make_event);
  find(library, ISO_SYMBOL(cuEventDestroy), d.destroy_event);
  find(library, ISO_SYMBOL(cuEventRecord), d.record_event);
  find(library, ISO_SYMBOL(cuEventElapsedTime), d.elapsed_time);
  find(library, ISO_SYMBOL(cuGetErrorName), d.error_name);
  find(library, ISO_SYMBOL(cuGetErrorString), d.error_text);
  return d;
}

}  // namespace

const Driver& driver() {
  static const Driver opened = open_driver();
  return opened;
}

void check(CUresult result, std::source_location place) {
  if (result == CUDA_SUCCESS) return;
  const char *name = nullptr, *text = nullptr;
  driver().error_name(result, &name);
  driver().error_text(result, &text);
  throw std::runtime_error(fmt::format("{}:{}: the CUDA driver says {}: {}", place.file_name(), place.line(),
                                       name ? name : "?", text ? text : "an error that it does not know"));
}

}  // namespace isocast
