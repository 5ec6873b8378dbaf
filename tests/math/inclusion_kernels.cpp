#include <math/inclusion_kernels.h>

namespace isocast {

namespace scalar {
extern const test::InclusionKernels inclusion_kernel_table;
}
namespace sse4 {
extern const test::InclusionKernels inclusion_kernel_table;
}
namespace avx2 {
extern const test::InclusionKernels inclusion_kernel_table;
}
namespace avx512 {
extern const test::InclusionKernels inclusion_kernel_table;
}

const test::InclusionKernels& test::inclusion_kernels(Isa isa) {
  static const InclusionKernels* const tables[kIsaCount] = {
      &scalar::inclusion_kernel_table, &sse4::inclusion_kernel_table, &avx2::inclusion_kernel_table,
      &avx512::inclusion_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
