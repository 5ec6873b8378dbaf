#include <isocast/cuda/host_kernels.h>
#include <isocast/cuda/volume_body.h>

#include <map>

namespace isocast {

HostKernel* host_volume_kernel(const std::string& name) {
#define ISO_ENTRY(T, name, ...)                                                                 \
  {"trace_" #T "_" #name,                                                                       \
   [](const void* body, std::int32_t block, std::int32_t thread, std::int32_t threads, void*) { \
     (*static_cast<const TraceVolume<T, __VA_ARGS__>*>(body))({block, thread, threads});        \
   }},
  static const std::map<std::string, HostKernel*> kernels = {
      ISO_EACH_DENSE_GRID(ISO_ENTRY, float) ISO_EACH_SPARSE_GRID(ISO_ENTRY, float)
          ISO_EACH_DENSE_GRID(ISO_ENTRY, double) ISO_EACH_SPARSE_GRID(ISO_ENTRY, double)};
#undef ISO_ENTRY
  const auto found = kernels.find(name);
  return found != kernels.end() ? found->second : nullptr;
}

}  // namespace isocast
