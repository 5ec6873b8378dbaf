#include <isocast/isa/cpu.h>
#include <isocast/render/kernels.h>

namespace isocast {

namespace scalar {
extern const RenderKernels render_kernel_table;
}
namespace sse4 {
extern const RenderKernels render_kernel_table;
}
namespace avx2 {
extern const RenderKernels render_kernel_table;
}
namespace avx512 {
extern const RenderKernels render_kernel_table;
}

const RenderKernels& render_kernels(Isa isa) {
  static const RenderKernels* const tables[kIsaCount] = {
      &scalar::render_kernel_table, &sse4::render_kernel_table, &avx2::render_kernel_table,
      &avx512::render_kernel_table};
  return *tables[static_cast<int>(isa)];
}

const RenderKernels& render_kernels() {
  static const RenderKernels& widest = render_kernels(widest_isa());
  return widest;
}

}  // namespace isocast
