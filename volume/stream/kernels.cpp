#include <isocast/isa/cpu.h>
#include <isocast/volume/stream/kernels.h>

namespace isocast {

namespace scalar {
extern const StreamKernels stream_kernel_table;
}
namespace sse4 {
extern const StreamKernels stream_kernel_table;
}
namespace avx2 {
extern const StreamKernels stream_kernel_table;
}
namespace avx512 {
extern const StreamKernels stream_kernel_table;
}

const StreamKernels& stream_kernels(Isa isa) {
  static const StreamKernels* const tables[kIsaCount] = {
      &scalar::stream_kernel_table, &sse4::stream_kernel_table, &avx2::stream_kernel_table,
      &avx512::stream_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
