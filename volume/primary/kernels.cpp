#include <isocast/isa/cpu.h>
#include <isocast/volume/primary/kernels.h>

namespace isocast {

namespace scalar {
extern const PrimaryKernels primary_kernel_table;
}
namespace sse4 {
extern const PrimaryKernels primary_kernel_table;
}
namespace avx2 {
extern const PrimaryKernels primary_kernel_table;
}
namespace avx512 {
extern const PrimaryKernels primary_kernel_table;
}

const PrimaryKernels& primary_kernels(Isa isa) {
  static const PrimaryKernels* const tables[kIsaCount] = {
      &scalar::primary_kernel_table, &sse4::primary_kernel_table, &avx2::primary_kernel_table,
      &avx512::primary_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
