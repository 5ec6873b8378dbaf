#include <isocast/isa/cpu.h>
#include <isocast/volume/dress_kernels.h>

namespace isocast {

namespace scalar {
extern const DressKernels dress_kernel_table;
}
namespace sse4 {
extern const DressKernels dress_kernel_table;
}
namespace avx2 {
extern const DressKernels dress_kernel_table;
}
namespace avx512 {
extern const DressKernels dress_kernel_table;
}

const DressKernels& dress_kernels(Isa isa) {
  static const DressKernels* const tables[kIsaCount] = {&scalar::dress_kernel_table,
                                                        &sse4::dress_kernel_table, &avx2::dress_kernel_table,
                                                        &avx512::dress_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
