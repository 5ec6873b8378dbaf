#include <isocast/volume/kernels.h>

namespace isocast {

namespace scalar { extern const VolumeKernels volume_kernel_table; }
namespace sse4 { extern const VolumeKernels volume_kernel_table; }
namespace avx2 { extern const VolumeKernels volume_kernel_table; }
namespace avx512 { extern const VolumeKernels volume_kernel_table; }

const VolumeKernels& volume_kernels(Isa isa) {
  static const VolumeKernels* const tables[kIsaCount] = {&scalar::volume_kernel_table, &sse4::volume_kernel_table,
                                                         &avx2::volume_kernel_table, &avx512::volume_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
