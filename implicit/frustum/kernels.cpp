#include <isocast/implicit/frustum/kernels.h>
#include <isocast/isa/cpu.h>

#include <algorithm>

namespace isocast {

#define ISOCAST_FRUSTUM_KERNELS(build)              \
  namespace build {                                 \
  extern const FrustumKernels frustum_kernel_table; \
  }
ISOCAST_FRUSTUM_KERNELS(scalar)
ISOCAST_FRUSTUM_KERNELS(sse4)
ISOCAST_FRUSTUM_KERNELS(avx2)
ISOCAST_FRUSTUM_KERNELS(avx512)
#undef ISOCAST_FRUSTUM_KERNELS

const FrustumKernels& frustum_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512: return avx512::frustum_kernel_table;
    case Isa::avx2: return avx2::frustum_kernel_table;
    case Isa::sse4: return sse4::frustum_kernel_table;
    default: return scalar::frustum_kernel_table;
  }
}

std::size_t frustum_scratch(const FrustumQuery& query) {
  const auto n = static_cast<std::size_t>(query.along.degree) + 1;
  const std::size_t row = (n + 7) / 8 * 8, patch = n * (n + 1) / 2 * row;
  // the block, a strip and a quarter on each of three levels, and a tile as other numbers; before that,
  // values and what is between them and the block's form
  return std::max(8 * patch, 2 * patch + n * (n + 1) * row) + 64;
}

}  // namespace isocast
