#include <isocast/isa/cpu.h>
#include <isocast/ray/neighbour_normals.h>

namespace isocast {

namespace scalar {
extern const NormalKernels normal_kernel_table;
}
namespace sse4 {
extern const NormalKernels normal_kernel_table;
}
namespace avx2 {
extern const NormalKernels normal_kernel_table;
}
namespace avx512 {
extern const NormalKernels normal_kernel_table;
}

const NormalKernels& normal_kernels(Isa isa) {
  static const NormalKernels* const tables[kIsaCount] = {
      &scalar::normal_kernel_table, &sse4::normal_kernel_table, &avx2::normal_kernel_table,
      &avx512::normal_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
