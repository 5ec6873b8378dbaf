#include <isocast/isa/cpu.h>
#include <isocast/scene/mesh/mesh_kernels.h>

namespace isocast {

namespace scalar {
extern const MeshKernels mesh_kernel_table;
}
namespace sse4 {
extern const MeshKernels mesh_kernel_table;
}
namespace avx2 {
extern const MeshKernels mesh_kernel_table;
}
namespace avx512 {
extern const MeshKernels mesh_kernel_table;
}

const MeshKernels& mesh_kernels(Isa isa) {
  static const MeshKernels* const tables[kIsaCount] = {&scalar::mesh_kernel_table, &sse4::mesh_kernel_table,
                                                       &avx2::mesh_kernel_table, &avx512::mesh_kernel_table};
  return *tables[static_cast<int>(isa)];
}

}  // namespace isocast
