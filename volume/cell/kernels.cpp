#include <isocast/isa/cpu.h>
#include <isocast/volume/cell/kernels.h>

namespace isocast {

namespace scalar {
extern const CellKernels cell_kernel_table;
}
namespace sse4 {
extern const CellKernels cell_kernel_table;
}
namespace avx2 {
extern const CellKernels cell_kernel_table;
}
namespace avx512 {
extern const CellKernels cell_kernel_table;
}

const CellKernels& cell_kernels(Isa isa) {
  static const CellKernels* const tables[kIsaCount] = {&scalar::cell_kernel_table, &sse4::cell_kernel_table,
                                                       &avx2::cell_kernel_table, &avx512::cell_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
